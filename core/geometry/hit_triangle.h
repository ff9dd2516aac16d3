// A ray against a triangle.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/geometry/vec.h"

namespace sightline {

/// Where the ray meets the triangle, in multiples of `along` (Möller and Trumbore, 1997); nothing behind `from` or
/// where the ray lies in its plane. Rounded: at an edge either answer may come.
inline std::optional<double> hit_triangle(const Vec<3>& from, const Vec<3>& along, const Vec<3>& a, const Vec<3>& b,
                                          const Vec<3>& c) {
    const Vec<3> ab = b - a, ac = c - a, p = glm::cross(along, ac);
    const double det = glm::dot(ab, p);
    if (det == 0) return std::nullopt;
    const Vec<3> s = from - a;
    const double u = glm::dot(s, p) / det;
    if (!(u >= 0 && u <= 1)) return std::nullopt;
    const Vec<3> q = glm::cross(s, ab);
    const double v = glm::dot(along, q) / det;
    if (!(v >= 0 && u + v <= 1)) return std::nullopt;
    const double t = glm::dot(ac, q) / det;
    return t > 0 ? std::optional(t) : std::nullopt;
}

}  // namespace sightline
