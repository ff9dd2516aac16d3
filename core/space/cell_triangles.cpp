// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/cell_triangles.h"

namespace sightline {

namespace {

/// A triangle thinner than that has no normal that doubles tell well.
constexpr double needle = 0x1p-20;

std::array<float, 3> floats(const Vec<3>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

CellTriangles::CellTriangles(const Scene<3>& scene, std::span<const std::uint32_t> references) {
    const Box<3> box = bounds<3>(scene.primitives);
    if (box.empty()) return;
    origin_ = box.centre();
    reach_ = box.longest_side();
    rows_.resize(references.size() + padding);
    for (std::size_t i = 0; i < references.size(); ++i) {
        const Primitive<3>& triangle = scene.primitives[references[i]];
        const Vec<3> a = triangle[0] - origin_, b = triangle[1] - origin_, c = triangle[2] - origin_;
        const Vec<3> centroid = (a + b + c) / 3.0, u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
        const Vec<3> across = glm::cross(u, v);
        CellTriangle& row = rows_[i];
        row.centroid = floats(centroid);
        // What rounding takes away is far below the margin of a float.
        row.radius = static_cast<float>(
            1.000001 * std::max({glm::length(a - centroid), glm::length(b - centroid), glm::length(c - centroid)}));
        if (glm::length(across) > needle * glm::length(u) * glm::length(v)) row.area = floats(across * 0.5);
        row.bits = references[i] | (shows_both_sides(scene, references[i]) ? CellTriangle::two_sided_bit : 0);
    }
}

ShownFilter::ShownFilter(const View<3>& view, const CellTriangles& triangles) {
    constexpr double largest = 1e18;  // products of three such are in the range of floats, or what they say is unsure
    const Vec<3> eye = view.eye - triangles.origin();
    const double size = std::abs(eye.x) + std::abs(eye.y) + std::abs(eye.z) + 3 * triangles.reach();
    if (view.all_round || !(size < largest)) return;
    eye_ = floats(eye);
    // Terms are no larger than `size`, and floats and their sums are off by a few units in the 24th place; the normal
    // of a thin triangle by 2^-31 of a unit more.
    unsure_distance_ = static_cast<float>(size * 0x1p-20) + tiny;
    for (std::size_t i = 0; i < view.planes.size(); ++i) {
        const ViewPlane& plane = view.planes[i];
        const double length = glm::length(plane.inward);
        // What is left at 0 says nothing: one that the eye and its corners hardly span.
        if (!(glm::length(plane.uncertainty) < 0x1p-30 * length && std::isfinite(length))) continue;
        const Vec<3> normal = plane.inward / length;
        x_[i] = static_cast<float>(normal.x);
        y_[i] = static_cast<float>(normal.y);
        z_[i] = static_cast<float>(normal.z);
        offset_[i] = static_cast<float>(glm::dot(normal, eye));
    }
}

}  // namespace sightline
