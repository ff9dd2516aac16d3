// The star-shape test: does the ray from the eye to a cell's centre pass through the facet it was reached by?
// (TVCG section 3.2, fig. 5 line 2)
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cell_complex.h"

namespace sightline {

/// `half` is the facet as the cell that was just projected sees it; `centre` is that of the neighbour. True also when
/// the ray only touches the facet's border. Exact on the given doubles.
inline bool star_shaped(const CellComplex<2>& cells, const HalfFacet& half, const Vec<2>& eye, const Vec<2>& centre) {
    const auto [a, b] = facet_ends(cells, half);
    return orient(a, b, eye) >= 0 && orient(eye, a, centre) >= 0 && orient(eye, centre, b) >= 0;
}

namespace detail {

/// The signs of volumes of tetrahedra that have one corner at 0 and none farther than `reach` from it on any axis. Let
/// u = 2^-53 and M the reach: coordinates are off by at most u M, a component of a cross product (at most 2 M^2) by
/// 8 u M^2, and the sum of its three products with the last corner by 46 u M^3. 64 u M^3 is asked for. In the range of
/// `reach` no underflow takes away that much.
class VolumeSigns {
public:
    explicit VolumeSigns(double reach)
        : bound_(reach > 1e-90 && reach < 1e90 ? reach * reach * reach * 0x1p-47
                                               : std::numeric_limits<double>::infinity()) {}
    /// Of dot(a, b x c): +1 or -1; 0 where that is not sure.
    int of(const Vec<3>& a, const Vec<3>& b_cross_c) const {
        const double volume = glm::dot(a, b_cross_c);
        return (volume > bound_) - (volume < -bound_);
    }

private:
    double bound_;
};

inline double reach_of(const Vec<3>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace detail

inline bool star_shaped(const CellComplex<3>& cells, const HalfFacet& half, const Vec<3>& eye, const Vec<3>& centre) {
    const auto polygon = cells.points_of_facet(half.facet());
    const int inside = half.flipped() ? 1 : -1;
    std::array<Vec<3>, 4> corner;  // relative to the eye; a facet has three or four
    const Vec<3> to = centre - eye;
    double reach = detail::reach_of(to);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        corner[i] = cells.points[polygon[i]] - eye;
        reach = std::max(reach, detail::reach_of(corner[i]));
    }
    // Signs in doubles where they are sure, and exact ones elsewhere: the answer is always that of the exact ones.
    const detail::VolumeSigns signs(reach);
    const int facing = signs.of(corner[0], glm::cross(corner[1], corner[2]));  // of orient(…, eye), turned about
    if ((facing == 0 ? facet_side(cells, half, eye) : inside * facing) < 0) return false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t next = i + 1 == polygon.size() ? 0 : i + 1;
        int turn = signs.of(to, glm::cross(corner[i], corner[next]));
        if (turn == 0) turn = orient(eye, cells.points[polygon[i]], cells.points[polygon[next]], centre);
        if (turn == -inside) return false;
    }
    return true;
}

}  // namespace sightline
