// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/cell_in_view.h"

namespace sightline {

bool cell_in_view(const CellComplex<2>& cells, const View<2>& view, std::uint32_t cell) {
    if (view.all_round) return true;
    const auto corners = cells.corners_of(cell);
    std::array<Vec<2>, 4> at;  // a triangle or a square
    for (std::size_t i = 0; i < corners.size(); ++i) at[i] = cells.points[corners[i]];
    return in_view(view, std::span<const Vec<2>>(at).first(corners.size()));
}

bool cell_in_view(const CellComplex<3>& cells, const View<3>& view, std::uint32_t cell) {
    const auto corners = cells.corners_of(cell);
    std::array<Vec<3>, 8> at;  // a tetrahedron or a cube
    for (std::size_t i = 0; i < corners.size(); ++i) at[i] = cells.points[corners[i]];
    return in_view(view, std::span<const Vec<3>>(at).first(corners.size()));
}

}  // namespace sightline
