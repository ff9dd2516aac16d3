// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/cell_rows.h"

#include <algorithm>

#include "core/space/cell_complex.h"

namespace sightline {

LargeVector<CellRow> cell_rows(const CellComplex<3>& cells) {
    LargeVector<CellRow> rows(cells.has_boxes() ? 0 : cells.cell_count());
    for (std::uint32_t cell = 0; cell < rows.size(); ++cell) {
        CellRow& row = rows[cell];
        const auto corners = cells.corners_of(cell);
        std::copy(corners.begin(), corners.end(), row.corners.begin());
        const auto facets = cells.facets_of(cell);
        std::copy(facets.begin(), facets.end(), row.facets.begin());
        for (std::size_t i = 0; i < 4; ++i) {
            row.apex[i] = none;
            const std::uint32_t behind = row.facets[i].neighbour;
            if (behind == none) continue;
            // The facet that leads back is the one with the same number; its corner lies opposite.
            const auto back = cells.facets_of(behind);
            for (std::size_t j = 0; j < 4; ++j)
                if (back[j].facet() == row.facets[i].facet()) row.apex[i] = cells.corners_of(behind)[j];
        }
    }
    return rows;
}

}  // namespace sightline
