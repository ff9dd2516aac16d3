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

inline bool star_shaped(const CellComplex<3>& cells, const HalfFacet& half, const Vec<3>& eye, const Vec<3>& centre) {
    if (facet_side(cells, half, eye) < 0) return false;
    const auto polygon = cells.points_of_facet(half.facet());
    const int inside = half.flipped() ? 1 : -1;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<3>& p = cells.points[polygon[i]];
        const Vec<3>& q = cells.points[polygon[i + 1 == polygon.size() ? 0 : i + 1]];
        if (orient(eye, p, q, centre) == -inside) return false;
    }
    return true;
}

}  // namespace sightline
