// Rays against all triangles of a scene, and distances to them, the slow and simple way.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/scene/scene.h"

namespace sightline::test {

/// The nearest triangle that the ray hits, by trying all (Möller and Trumbore 1997).
struct Hit {
    std::size_t triangle = 0;
    double distance = std::numeric_limits<double>::infinity();
};
inline Hit cast(const std::vector<Primitive<3>>& triangles, const Vec<3>& eye, const Vec<3>& direction) {
    Hit hit;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const Primitive<3>& t = triangles[k];
        const Vec<3> e1 = t[1] - t[0], e2 = t[2] - t[0], p = glm::cross(direction, e2);
        const double det = glm::dot(e1, p);
        if (det == 0) continue;
        const Vec<3> s = eye - t[0];
        const double u = glm::dot(s, p) / det;
        if (u < 0 || u > 1) continue;
        const Vec<3> q = glm::cross(s, e1);
        const double v = glm::dot(direction, q) / det, distance = glm::dot(e2, q) / det;
        if (v < 0 || u + v > 1 || distance <= 0 || distance >= hit.distance) continue;
        hit = {k, distance};
    }
    return hit;
}

inline double distance_to(const Primitive<3>& t, const Vec<3>& p) {
    const Vec<3> normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    bool above = true;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec<3> a = t[i], side = t[(i + 1) % 3] - a;
        above = above && glm::dot(glm::cross(normal, side), p - a) >= 0;
        const double along = std::clamp(glm::dot(p - a, side) / glm::dot(side, side), 0.0, 1.0);
        const Vec<3> off = p - a - along * side;
        nearest = std::min(nearest, glm::dot(off, off));
    }
    return above ? std::abs(glm::dot(normal, p - t[0])) / std::sqrt(glm::dot(normal, normal)) : std::sqrt(nearest);
}

}  // namespace sightline::test
