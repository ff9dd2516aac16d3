// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/outside.h"

#include <algorithm>

namespace sightline {

template <int D>
std::vector<std::uint32_t> reaching_outside(const CellComplex<D>& cells, const std::vector<Primitive<D>>& primitives) {
    std::vector<std::uint32_t> outside;
    if (cells.has_boxes()) return outside;  // they fill the box of the scene
    for (const std::uint32_t cell : cells.border_cells)
        for (const HalfFacet& half : cells.facets_of(cell)) {
            if (half.neighbour != none) continue;
            for (const std::uint32_t primitive : cells.primitives_of(cell))
                if (std::any_of(primitives[primitive].begin(), primitives[primitive].end(),
                                [&](const Vec<D>& corner) { return facet_side(cells, half, corner) < 0; }))
                    outside.push_back(primitive);
        }
    if (cells.unassigned > 0) {
        std::vector<std::uint8_t> in_a_cell(primitives.size());
        for (const std::uint32_t primitive : cells.cell_primitives) in_a_cell[primitive] = 1;
        for (std::uint32_t primitive = 0; primitive < in_a_cell.size(); ++primitive)
            if (!in_a_cell[primitive]) outside.push_back(primitive);
    }
    std::sort(outside.begin(), outside.end());
    outside.erase(std::unique(outside.begin(), outside.end()), outside.end());
    return outside;
}

template std::vector<std::uint32_t> reaching_outside<2>(const CellComplex<2>&, const std::vector<Primitive<2>>&);
template std::vector<std::uint32_t> reaching_outside<3>(const CellComplex<3>&, const std::vector<Primitive<3>>&);

}  // namespace sightline
