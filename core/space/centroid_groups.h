// The primitives of a scene in groups that lie close together, each known by its centroid.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cell_triangles.h"

namespace sightline {

/// The mean of the corners, rounded.
template <int D>
Vec<D> centroid(const Primitive<D>& primitive) {
    Vec<D> sum(0);
    for (const Vec<D>& corner : primitive) sum += corner;
    return sum / static_cast<double>(D);
}

/// Places along a curve through all centroids (that of Morton, 1966), on which neighbours lie close together. Group g
/// is places [64 g, 64 g + 64).
template <int D>
struct CentroidGroups {
    static constexpr std::uint32_t group_size = 64;
    LargeVector<std::uint32_t> primitives;  ///< at each place
    LargeVector<Vec<D>> centroids;
    std::vector<Box<D>> boxes;  ///< of the centroids of each group
    CellTriangles triangles;    ///< 3D, at each place

    std::span<const std::uint32_t> group(std::uint32_t g) const {
        return std::span(primitives).subspan(std::size_t{g} * group_size).first(count(g));
    }
    std::uint32_t count(std::uint32_t g) const {
        return std::min(group_size, static_cast<std::uint32_t>(primitives.size()) - g * group_size);
    }
};

template <int D>
CentroidGroups<D> centroid_groups(const Scene<D>& scene);

extern template CentroidGroups<2> centroid_groups<2>(const Scene<2>&);
extern template CentroidGroups<3> centroid_groups<3>(const Scene<3>&);

}  // namespace sightline
