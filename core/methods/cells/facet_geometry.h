// Centroid and normal of a facet, and the cosine between its normal and a direction.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cell_complex.h"

namespace sightline {

template <int D>
struct FacetGeometry {
    Vec<D> centroid;
    Vec<D> normal;  ///< from the cell that sees the facet to its neighbour; length arbitrary
};

inline FacetGeometry<2> facet_geometry(const CellComplex<2>& cells, const HalfFacet& half) {
    const auto [a, b] = facet_ends(cells, half);
    return {(a + b) * 0.5, {b.y - a.y, a.x - b.x}};
}

inline FacetGeometry<3> facet_geometry(const CellComplex<3>& cells, const HalfFacet& half) {
    const auto polygon = cells.points_of_facet(half.facet());
    Vec<3> sum(0);
    for (const std::uint32_t p : polygon) sum += cells.points[p];
    const Vec<3>&p0 = cells.points[polygon[0]], &p1 = cells.points[polygon[1]], &p2 = cells.points[polygon[2]];
    const Vec<3> inward = glm::cross(p1 - p0, p2 - p0);
    return {sum / static_cast<double>(polygon.size()), half.flipped() ? inward : -inward};
}

/// Cosine of the angle between two vectors of any length; 0 when one of them is zero.
template <int D>
double cosine(Vec<D> a, Vec<D> b) {
    double product = glm::dot(a, a) * glm::dot(b, b);
    if (!(product > 1e-280 && product < 1e280)) {  // squares left the range of doubles, or a vector is zero
        double size_a = 0, size_b = 0;
        for (int i = 0; i < D; ++i) {
            size_a = std::max(size_a, std::abs(a[i]));
            size_b = std::max(size_b, std::abs(b[i]));
        }
        if (size_a == 0 || size_b == 0) return 0;
        a /= size_a;
        b /= size_b;
        product = glm::dot(a, a) * glm::dot(b, b);
    }
    return glm::dot(a, b) / std::sqrt(product);
}

}  // namespace sightline
