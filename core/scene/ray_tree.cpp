// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/ray_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace sightline {

namespace {

/// The lowest 21 bits, two zeros after each.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 32) & 0x1f00000000ffffull;
    bits = (bits | bits << 16) & 0x1f0000ff0000ffull;
    bits = (bits | bits << 8) & 0x100f00f00f00f00full;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3ull;
    return (bits | bits << 2) & 0x1249249249249249ull;
}

double squared_area(const Primitive<3>& t) {
    const Vec<3> normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    return glm::dot(normal, normal);
}

std::vector<std::uint32_t> largest(const std::vector<Primitive<3>>& triangles, std::size_t most) {
    std::vector<std::uint32_t> chosen(triangles.size());
    std::iota(chosen.begin(), chosen.end(), 0u);
    if (chosen.size() <= most) return chosen;
    std::vector<float> areas(triangles.size());
    for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = static_cast<float>(squared_area(triangles[i]));
    std::nth_element(
        chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(most), chosen.end(),
        [&](std::uint32_t a, std::uint32_t b) { return areas[a] != areas[b] ? areas[a] > areas[b] : a < b; });
    chosen.resize(most);
    return chosen;
}

}  // namespace

RayTree::RayTree(const std::vector<Primitive<3>>& triangles, std::size_t most) {
    const std::vector<std::uint32_t> chosen = largest(triangles, most);
    Box<3> box;
    for (const std::uint32_t i : chosen)
        for (const Vec<3>& v : triangles[i]) box.add(v);
    const double scale = box.longest_side() > 0 ? 0x1p21 * (1 - 1e-9) / box.longest_side() : 0;
    struct Place {
        std::uint64_t key;
        std::uint32_t index;
        bool operator<(const Place& other) const { return key != other.key ? key < other.key : index < other.index; }
    };
    std::vector<Place> places;
    places.reserve(chosen.size());
    for (const std::uint32_t i : chosen) {
        const Primitive<3>& t = triangles[i];
        const Vec<3> at = ((t[0] + t[1] + t[2]) / 3.0 - box.min) * scale;
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis)
            key |= spread(static_cast<std::uint64_t>(std::clamp(at[axis], 0.0, 0x1p21 - 1))) << axis;
        places.push_back({key, i});
    }
    std::sort(places.begin(), places.end());

    const std::size_t leaves = (places.size() + leaf_size - 1) / leaf_size;
    while (first_leaf_ < leaves) first_leaf_ *= 2;
    nodes_.resize(2 * first_leaf_);
    triangles_.reserve(places.size());
    for (const Place& place : places) {
        const Primitive<3>& t = triangles[place.index];
        Bounds& leaf = nodes_[first_leaf_ + triangles_.size() / leaf_size];
        for (const Vec<3>& v : t) {
            leaf.min = glm::min(leaf.min, Point(v));
            leaf.max = glm::max(leaf.max, Point(v));
        }
        triangles_.push_back({Point(t[0]), Point(t[1] - t[0]), Point(t[2] - t[0]), place.index});
    }
    for (std::size_t i = first_leaf_ - 1; i > 0; --i) {
        nodes_[i].min = glm::min(nodes_[2 * i].min, nodes_[2 * i + 1].min);
        nodes_[i].max = glm::max(nodes_[2 * i].max, nodes_[2 * i + 1].max);
    }
}

RayTree::Hit RayTree::cast(const Vec<3>& from, const Vec<3>& direction, double after) const {
    const Point origin(from), ray(direction);
    Point inverse;
    for (int i = 0; i < 3; ++i) inverse[i] = 1 / (std::abs(ray[i]) > 1e-30f ? ray[i] : 1e-30f);
    const auto least = static_cast<float>(after);
    float nearest = std::numeric_limits<float>::infinity();
    Hit hit;
    // Where the ray enters a box; infinity when it misses it, and for the boxes without triangles that fill up the last
    // rows of the tree: their infinite sides would count as met.
    const auto entry = [&](const Bounds& box) {
        if (box.min.x > box.max.x) return std::numeric_limits<float>::infinity();
        float in = least, out = nearest;
        for (int i = 0; i < 3; ++i) {
            const float low = (box.min[i] - origin[i]) * inverse[i], high = (box.max[i] - origin[i]) * inverse[i];
            in = std::max(in, std::min(low, high));
            out = std::min(out, std::max(low, high));
        }
        return in <= out ? in : std::numeric_limits<float>::infinity();
    };

    struct Visit {
        std::size_t node;
        float entry;
    };
    std::array<Visit, 64> stack;
    std::size_t depth = 0;
    if (!triangles_.empty()) stack[depth++] = {1, least};
    while (depth > 0) {
        const Visit visit = stack[--depth];
        if (visit.entry > nearest) continue;
        if (visit.node < first_leaf_) {
            Visit left{2 * visit.node, entry(nodes_[2 * visit.node])};
            Visit right{2 * visit.node + 1, entry(nodes_[2 * visit.node + 1])};
            if (left.entry < right.entry) std::swap(left, right);
            for (const Visit& child : {left, right})  // the nearer one on top
                if (child.entry < std::numeric_limits<float>::infinity()) stack[depth++] = child;
            continue;
        }
        const std::size_t begin = (visit.node - first_leaf_) * leaf_size;
        for (std::size_t k = begin; k < std::min(begin + leaf_size, triangles_.size()); ++k) {
            // Möller and Trumbore 1997.
            const Triangle& t = triangles_[k];
            const Point p = glm::cross(ray, t.other_edge);
            const float determinant = glm::dot(t.edge, p);
            if (determinant == 0) continue;
            const Point s = origin - t.corner;
            const float u = glm::dot(s, p) / determinant;
            if (!(u >= 0 && u <= 1)) continue;
            const Point q = glm::cross(s, t.edge);
            const float v = glm::dot(ray, q) / determinant, distance = glm::dot(t.other_edge, q) / determinant;
            if (!(v >= 0 && u + v <= 1 && distance > least && distance < nearest)) continue;
            nearest = distance;
            hit = {distance, t.index, determinant > 0};
        }
    }
    return hit;
}

}  // namespace sightline
