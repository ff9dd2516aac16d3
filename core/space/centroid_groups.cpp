// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/centroid_groups.h"

namespace sightline {

namespace {

/// Where p lies on the curve through the box: the bits of its coordinates in turn.
template <int D>
std::uint64_t place_on_curve(const Vec<D>& p, const Box<D>& box) {
    constexpr int bits = 30 / D;
    constexpr double last = (1 << bits) - 1;
    std::uint64_t place = 0;
    for (int axis = 0; axis < D; ++axis) {
        const double at = (p[axis] - box.min[axis]) / (box.max[axis] - box.min[axis]) * last;
        const auto step = static_cast<std::uint64_t>(at > 0 && at < last ? at : at >= last ? last : 0);  // 0 for NaN
        for (int bit = 0; bit < bits; ++bit) place |= (step >> bit & 1) << (bit * D + axis);
    }
    return place;
}

}  // namespace

template <int D>
CentroidGroups<D> centroid_groups(const Scene<D>& scene) {
    const std::size_t count = scene.primitives.size();
    std::vector<Vec<D>> centroids;
    centroids.reserve(count);
    Box<D> box;
    for (const Primitive<D>& primitive : scene.primitives) {
        centroids.push_back(centroid<D>(primitive));
        box.add(centroids.back());
    }
    std::vector<std::uint64_t> places;  // and behind them the primitives
    places.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) places.push_back(place_on_curve<D>(centroids[i], box) << 32 | i);
    std::sort(places.begin(), places.end());

    CentroidGroups<D> groups;
    groups.primitives.reserve(count);
    groups.centroids.reserve(count);
    for (const std::uint64_t place : places) {
        const auto primitive = static_cast<std::uint32_t>(place);
        if (groups.primitives.size() % CentroidGroups<D>::group_size == 0) groups.boxes.emplace_back();
        groups.primitives.push_back(primitive);
        groups.centroids.push_back(centroids[primitive]);
        groups.boxes.back().add(centroids[primitive]);
    }
    if constexpr (D == 3) groups.triangles = CellTriangles(scene, groups.primitives);
    return groups;
}

template CentroidGroups<2> centroid_groups<2>(const Scene<2>&);
template CentroidGroups<3> centroid_groups<3>(const Scene<3>&);

}  // namespace sightline
