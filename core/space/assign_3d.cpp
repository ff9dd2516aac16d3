// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/builders.h"

namespace sightline {

CellComplex<3> tessellation(const Scene<3>& scene, const Settings& settings) {
    return tree_cells(build_tree<3>(scene.primitives, settings.error_bound));
}

void assign_primitives(CellComplex<3>& cells, const std::vector<Primitive<3>>& primitives) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t p = 0; p < primitives.size(); ++p) {
        Box<3> box;
        for (const Vec<3>& v : primitives[p]) box.add(v);
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            Box<3> c;
            for (const std::uint32_t corner : cells.corners_of(cell)) c.add(cells.points[corner]);
            bool meets = true;
            for (int i = 0; i < 3; ++i) meets = meets && c.min[i] <= box.max[i] && box.min[i] <= c.max[i];
            if (meets) pairs.emplace_back(cell, p);
        }
    }
    set_cell_primitives(cells, std::span<const std::pair<std::uint32_t, std::uint32_t>>(pairs));
}

}  // namespace sightline
