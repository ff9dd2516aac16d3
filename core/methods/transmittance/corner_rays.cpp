// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/corner_rays.h"

#include <algorithm>
#include <cmath>

namespace sightline {

namespace {

/// The leaf next to p on that side of each axis; none outside the root.
template <int D>
std::uint32_t leaf_beside(const Tree<D>& tree, const Vec<D>& p, std::uint32_t upwards) {
    const auto goes_up = [&](int axis) { return (upwards >> axis & 1) != 0; };
    for (int i = 0; i < D; ++i)
        if (goes_up(i) ? !(p[i] < tree.root_box().max[i]) : !(p[i] > tree.root_box().min[i])) return none;
    std::uint32_t node = 0;
    while (tree.nodes[node].first_child != none) {
        const Vec<D> middle = tree.nodes[tree.nodes[node].first_child].box.max;
        std::uint32_t child = 0, bit = 0;
        for (int i = 0; i < D; ++i)
            if (tree.splits(node, i))
                child |= static_cast<std::uint32_t>(p[i] > middle[i] || (p[i] == middle[i] && goes_up(i))) << bit++;
        node = tree.nodes[node].first_child + child;
    }
    return tree.nodes[node].leaf;
}

template <int D>
std::array<float, D> floats_of(const Vec<D>& v) {
    std::array<float, D> floats;
    for (int i = 0; i < D; ++i) floats[static_cast<std::size_t>(i)] = static_cast<float>(v[i]);
    return floats;
}

/// How often each edge of the simplex at its first corner goes into d.
std::array<double, 2> along_edges(const std::array<Vec<2>, 2>& edges, const Vec<2>& d) {
    const double whole = cross(edges[0], edges[1]);
    return {cross(d, edges[1]) / whole, cross(edges[0], d) / whole};
}
std::array<double, 3> along_edges(const std::array<Vec<3>, 3>& edges, const Vec<3>& d) {
    const Vec<3> across = glm::cross(edges[1], edges[2]), other = glm::cross(d, edges[0]);
    const double whole = glm::dot(edges[0], across);
    return {glm::dot(d, across) / whole, glm::dot(other, edges[2]) / -whole, glm::dot(other, edges[1]) / whole};
}

}  // namespace

template <int D>
CornerRays<D>::CornerRays(const CellComplex<D>& cells) {
    if (cells.has_boxes()) {
        set_boxes(cells);
        return;
    }
    begin_.assign(cells.points.size() + 1, 0);
    for (const std::uint32_t corner : cells.cell_points) ++begin_[corner + 1];
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    cells_.resize(cells.cell_points.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    outside_.assign(cells.points.size(), 0);
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        for (const std::uint32_t corner : cells.corners_of(cell)) cells_[next[corner]++] = cell;
        for (const HalfFacet& half : cells.facets_of(cell))
            if (half.neighbour == none)
                for (const std::uint32_t point : cells.points_of_facet(half.facet())) outside_[point] = 1;
    }
}

template <int D>
void CornerRays<D>::set_boxes(const CellComplex<D>& cells) {
    constexpr std::uint32_t corner_count = 1 << D;
    origin_ = cells.tree.root_box().centre();
    boxes_.resize(cells.cell_count());
    points_.resize(cells.points.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        points_[i].at = floats_of<D>(cells.points[i] - origin_);
        points_[i].cells.fill(none);
    }
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const Box<D>& box = cells.tree.nodes[cells.tree.leaves[cell]].box;
        CellBox& known = boxes_[cell];
        known.min = floats_of<D>(box.min - origin_);
        known.max = floats_of<D>(box.max - origin_);
        const auto corners = cells.corners_of(cell);
        for (std::uint32_t i = 0; i < corner_count; ++i) {
            const auto upper = static_cast<std::uint32_t>(Box<D>::corner_bits(static_cast<int>(i)));
            known.corners[upper] = corners[i];
            points_[corners[i]].cells[corner_count - 1 - upper] = cell;
        }
    }
    // A point in the middle of a larger box's side is no corner of that.
    for (std::size_t i = 0; i < points_.size(); ++i)
        for (std::uint32_t side = 0; side < corner_count; ++side)
            if (points_[i].cells[side] == none) points_[i].cells[side] = leaf_beside(cells.tree, cells.points[i], side);
}

template <int D>
CornerRay<D> CornerRays<D>::through_box(std::uint32_t corner, const Vec<D>& eye) const {
    const Point& p = points_[corner];
    const std::size_t upwards = this->upwards(p, eye);
    CornerRay<D> ray;
    ray.cell = p.cells[upwards];
    if (ray.cell == none) return ray;
    const CellBox& box = boxes_[ray.cell];
    std::array<float, D> d;
    for (std::size_t i = 0; i < D; ++i) {
        d[i] = along(p, eye, i);
        const int axis = static_cast<int>(i);
        ray.to_eye[axis] = eye[axis] - origin_[axis] - 0.5 * (double{box.min[i]} + double{box.max[i]});
    }
    float shortest = 1;
    std::size_t across = D;
    for (std::size_t i = 0; i < D; ++i) {
        if (d[i] == 0) continue;
        const float there = ((d[i] < 0 ? box.min[i] : box.max[i]) - p.at[i]) / d[i];
        if (there < shortest) {
            shortest = there;
            across = i;
        }
    }
    ray.ends = across == D;
    if (ray.ends) return ray;
    // From one corner of the side to all of them, axis by axis.
    ray.corners[0] = box.corners[upwards & std::size_t{1} << across];
    std::array<std::size_t, CornerRay<D>::most_corners> bits{upwards & std::size_t{1} << across};
    ray.weights[0] = 1;
    ray.count = 1;
    for (std::size_t i = 0; i < D; ++i) {
        if (i == across) continue;
        const float extent = box.max[i] - box.min[i];
        const float share =
            extent > 0 ? std::clamp((p.at[i] + d[i] * shortest - box.min[i]) / extent, 0.0f, 1.0f) : 0.0f;
        const std::uint32_t before = ray.count;
        for (std::uint32_t c = 0; c < before; ++c) {
            if (share == 0) continue;
            const std::uint32_t at = share == 1 ? c : ray.count++;
            bits[at] = bits[c] | std::size_t{1} << i;
            ray.corners[at] = box.corners[bits[at]];
            ray.weights[at] = ray.weights[c] * share;
            if (at != c) ray.weights[c] *= 1 - share;
        }
    }
    return ray;
}

template <int D>
CornerRay<D> CornerRays<D>::through_simplex(const CellComplex<D>& cells, std::uint32_t corner,
                                            const Vec<D>& eye) const {
    const Vec<D> p = cells.points[corner], d = eye - p;
    CornerRay<D> ray;
    std::array<std::uint32_t, D> others{};
    std::array<double, D> along{};
    double most = -1;
    for (std::uint32_t i = begin_[corner]; i < begin_[corner + 1]; ++i) {
        std::array<std::uint32_t, D> there{};
        std::array<Vec<D>, D> edges;
        std::size_t n = 0;
        for (const std::uint32_t point : cells.corners_of(cells_[i]))
            if (point != corner && n < D) {
                there[n] = point;
                edges[n++] = cells.points[point] - p;
            }
        const std::array<double, D> shares = along_edges(edges, d);
        double sum = 0, least = shares[0];
        for (const double share : shares) {
            sum += std::abs(share);
            least = std::min(least, share);
        }
        if (!(sum > 0 && least / sum > most)) continue;
        most = least / sum;
        others = there;
        along = shares;
        ray.cell = cells_[i];
        if (least > 0) break;
    }
    if (most < 0 && outside_[corner]) ray.cell = none;
    if (ray.cell == none) return ray;
    ray.to_eye = eye - cells.centre(ray.cell);
    double sum = 0, counted = 0;
    for (const double share : along) sum += std::max(share, 0.0);
    ray.ends = !(sum > 1);
    if (ray.ends) return ray;
    const double distance = glm::dot(d, d);
    for (std::size_t i = 0; i < D; ++i) {
        const Vec<D> away = eye - cells.points[others[i]];
        if (!(along[i] > 0 && glm::dot(away, away) < distance)) continue;
        ray.corners[ray.count] = others[i];
        ray.weights[ray.count++] = static_cast<float>(along[i]);
        counted += along[i];
    }
    for (std::size_t i = 0; i < ray.count; ++i) ray.weights[i] /= static_cast<float>(counted);
    return ray;
}

template <int D>
std::shared_ptr<const CornerRays<D>> corner_rays(const Problem<D>& problem) {
    return problem.cells->made->template of<CornerRays<D>>("corner rays",
                                                           [&] { return CornerRays<D>(*problem.cells); });
}

template class CornerRays<2>;
template class CornerRays<3>;
template std::shared_ptr<const CornerRays<2>> corner_rays<2>(const Problem<2>&);
template std::shared_ptr<const CornerRays<3>> corner_rays<3>(const Problem<3>&);

}  // namespace sightline
