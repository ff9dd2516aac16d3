// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/corner_light.h"

#include <algorithm>
#include <limits>

namespace sightline {

namespace {

/// Terms of the weights from the values at the corners, in their order.
template <int D>
void set_terms(LightInside<D>& light, const std::array<float, 1 << D>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        light.terms[static_cast<std::size_t>(Box<D>::corner_bits(static_cast<int>(i)))] = values[i];
    for (std::size_t bit = 1; bit < values.size(); bit *= 2)
        for (std::size_t i = 0; i < values.size(); ++i)
            if (i & bit) light.terms[i] -= light.terms[i - bit];
}

/// Along each axis, of a plane that rises by `rises` along `edges`; 0 where the edges span nothing.
Vec<2> slope(const std::array<Vec<2>, 2>& edges, const std::array<double, 2>& rises) {
    const double whole = cross(edges[0], edges[1]);
    if (whole == 0) return Vec<2>(0);
    return Vec<2>(rises[0] * edges[1].y - rises[1] * edges[0].y, rises[1] * edges[0].x - rises[0] * edges[1].x) / whole;
}
Vec<3> slope(const std::array<Vec<3>, 3>& edges, const std::array<double, 3>& rises) {
    const Vec<3> across = glm::cross(edges[1], edges[2]);
    const double whole = glm::dot(edges[0], across);
    if (whole == 0) return Vec<3>(0);
    return (across * rises[0] + glm::cross(edges[2], edges[0]) * rises[1] + glm::cross(edges[0], edges[1]) * rises[2]) /
           whole;
}

}  // namespace

/// In rounds instead of by recursion, since a ray may go through as many cells as there are.
template <int D>
float CornerLight<D>::found(const Problem<D>& problem, std::uint32_t corner) const {
    pending_.clear();
    pending_.push_back({corner, 0, ray(problem, corner)});
    for (;;) {
        Pending& last = pending_.back();
        const CornerRay<D>& ray = last.ray;
        while (last.next < ray.count && corners_[ray.corners[last.next]].epoch == epoch_) ++last.next;
        if (last.next < ray.count) {
            const std::uint32_t before = ray.corners[last.next];
            pending_.push_back({before, 0, this->ray(problem, before)});
            continue;
        }
        float value = 1;
        if (ray.cell != none && !ray.ends) {
            // Of what is missing, so that weights that are rounded keep all where nothing is.
            float missing = 0;
            for (std::uint32_t i = 0; i < ray.count; ++i)
                missing += ray.weights[i] * (1 - corners_[ray.corners[i]].value);
            value = std::max(0.0f, 1 - missing) * open(ray);
        }
        corners_[last.corner] = {value, epoch_};
        pending_.pop_back();
        if (pending_.empty()) return value;
    }
}

template <int D>
LightInside<D> CornerLight<D>::inside(const Problem<D>& problem, std::uint32_t cell, const Vec<D>& origin) const {
    const CellComplex<D>& cells = *problem.cells;
    const auto corners = cells.corners_of(cell);
    std::array<float, 1 << D> values{};
    for (std::size_t i = 0; i < corners.size(); ++i) values[i] = at(problem, corners[i]);
    LightInside<D> light;
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(corners.size());
    light.least = *std::min_element(values.begin(), end);
    light.most = *std::max_element(values.begin(), end);
    const auto set = [&](std::size_t axis, double from, double scale) {
        light.origin[axis] = static_cast<float>(from - origin[static_cast<int>(axis)]);
        light.scale[axis] = static_cast<float>(scale);
    };
    if (cells.has_boxes()) {
        const Box<D>& box = cells.tree.nodes[cells.tree.leaves[cell]].box;
        for (int i = 0; i < D; ++i) set(static_cast<std::size_t>(i), box.min[i], 1 / (box.max[i] - box.min[i]));
        light.farthest = 1;
        set_terms(light, values);
        return light;
    }
    light.farthest = std::numeric_limits<float>::max();
    light.nearest = -light.farthest;
    light.terms[0] = values[0];
    std::array<Vec<D>, D> edges;
    std::array<double, D> rises;
    for (std::size_t i = 0; i < D; ++i) {
        edges[i] = cells.points[corners[i + 1]] - cells.points[corners[0]];
        rises[i] = static_cast<double>(values[i + 1] - values[0]);
    }
    const Vec<D> gradient = slope(edges, rises);
    for (int i = 0; i < D; ++i) {
        set(static_cast<std::size_t>(i), cells.points[corners[0]][i], 1);
        light.terms[std::size_t{1} << i] = static_cast<float>(gradient[i]);
    }
    return light;
}

template class CornerLight<2>;
template class CornerLight<3>;

}  // namespace sightline
