// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/facing.h"

#include <cmath>

namespace sightline {

namespace {

/// A triangle as thin as that has no normal that doubles tell well.
constexpr double thinnest = 0x1p-20;

}  // namespace

FacingPlanes::FacingPlanes(const Scene<3>& scene, std::span<const std::uint32_t> order) {
    const Box<3> box = bounds<3>(scene.primitives);
    if (box.empty()) return;
    origin_ = box.centre();
    reach_ = box.longest_side();
    for (auto* const part : {&x_, &y_, &z_, &offset_}) part->resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Primitive<3>& triangle = scene.primitives[order[i]];
        Vec<3> normal(0);
        double offset = 0;
        if (shows_both_sides(scene, order[i])) {
            offset = -std::numeric_limits<float>::max();  // on its inner side from anywhere
        } else {
            const Vec<3> u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
            const Vec<3> across = glm::cross(u, v);
            const double length = glm::length(across);
            if (length > thinnest * glm::length(u) * glm::length(v)) {
                normal = across / length;
                offset = glm::dot(normal, triangle[0] - origin_);
            }
        }
        x_[i] = static_cast<float>(normal.x);
        y_[i] = static_cast<float>(normal.y);
        z_[i] = static_cast<float>(normal.z);
        offset_[i] = static_cast<float>(offset);
    }
}

void FacingPlanes::tell(const Vec<3>& eye, std::size_t begin, std::span<SideSeen> out) const {
    const Vec<3> from = eye - origin_;
    const auto x = static_cast<float>(from.x), y = static_cast<float>(from.y), z = static_cast<float>(from.z);
    // The terms are no larger than that, and normals, offsets and sums are off by a few units in the 24th place; a
    // normal of a thin triangle by 2^-31 of a unit more.
    const auto unsure =
        static_cast<float>((std::abs(from.x) + std::abs(from.y) + std::abs(from.z) + 3 * reach_) * 0x1p-20);
    const float *const nx = x_.data() + begin, *const ny = y_.data() + begin, *const nz = z_.data() + begin,
                       *const offset = offset_.data() + begin;
    auto* const to = reinterpret_cast<std::uint8_t*>(out.data());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float side = nx[i] * x + ny[i] * y + nz[i] * z - offset[i];
        // 0, 1, 2: away, unsure, seen; anything but a number is unsure.
        to[i] = static_cast<std::uint8_t>(1 + (side > unsure) - (side < -unsure));
    }
}

}  // namespace sightline
