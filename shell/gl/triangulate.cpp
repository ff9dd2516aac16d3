// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/gl/triangulate.h"

#include <numeric>

namespace sightline {

namespace {

double turn(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) { return cross(b - a, c - a); }

bool is_convex(std::span<const Vec<2>> p) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double t = turn(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]);
        left |= t > 0;
        right |= t < 0;
    }
    return !(left && right);
}

}  // namespace

void triangulate(std::span<const Vec<2>> polygon, std::vector<std::uint32_t>& triangles) {
    const auto count = static_cast<std::uint32_t>(polygon.size());
    if (count < 3) return;
    if (count == 3 || is_convex(polygon)) {
        for (std::uint32_t i = 2; i < count; ++i) triangles.insert(triangles.end(), {0, i - 1, i});
        return;
    }
    double area = 0;
    for (std::uint32_t i = 2; i < count; ++i) area += turn(polygon[0], polygon[i - 1], polygon[i]);
    const double sign = area < 0 ? -1 : 1;
    std::vector<std::uint32_t> left(count);
    std::iota(left.begin(), left.end(), 0u);
    const auto is_ear = [&](std::size_t before, std::size_t at, std::size_t after) {
        const Vec<2>&a = polygon[left[before]], &b = polygon[left[at]], &c = polygon[left[after]];
        if (sign * turn(a, b, c) <= 0) return false;
        for (const std::uint32_t other : left) {
            const Vec<2>& p = polygon[other];
            if (p == a || p == b || p == c) continue;
            if (sign * turn(a, b, p) >= 0 && sign * turn(b, c, p) >= 0 && sign * turn(c, a, p) >= 0) return false;
        }
        return true;
    };
    std::size_t at = 0, refused = 0;
    while (left.size() > 3) {
        const std::size_t n = left.size(), before = (at + n - 1) % n, after = (at + 1) % n;
        // After a whole round without an ear the polygon crosses itself or a corner is flat: any corner will do.
        if (refused < n && !is_ear(before, at, after)) {
            at = after;
            ++refused;
            continue;
        }
        triangles.insert(triangles.end(), {left[before], left[at], left[after]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
        at = before > at ? left.size() - 1 : before;
        refused = 0;
    }
    triangles.insert(triangles.end(), {left[0], left[1], left[2]});
}

}  // namespace sightline
