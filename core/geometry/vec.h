// Points, vectors and boxes in D dimensions. Coordinates are doubles in scene units.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace sightline {

/// A point or a direction; D is 2 or 3.
template <int D>
using Vec = glm::vec<D, double, glm::defaultp>;

/// Twice the signed area of the triangle (0, a, b); positive when b is counter-clockwise of a. Rounded.
inline double cross(const Vec<2>& a, const Vec<2>& b) { return a.x * b.y - a.y * b.x; }

template <int D>
bool is_finite(const Vec<D>& p) {
    for (int i = 0; i < D; ++i)
        if (!std::isfinite(p[i])) return false;
    return true;
}

/// An axis-aligned box; empty (min > max) until the first point is added.
template <int D>
struct Box {
    Vec<D> min{std::numeric_limits<double>::infinity()};
    Vec<D> max{-std::numeric_limits<double>::infinity()};

    bool empty() const { return min.x > max.x; }
    Vec<D> centre() const { return (min + max) * 0.5; }
    Vec<D> extent() const { return max - min; }
    /// Corner i of 2^D: bit a of i takes the upper end of axis a. 2D: corners 2 and 3 change places, so that the
    /// corners go round counter-clockwise.
    Vec<D> corner(int i) const {
        Vec<D> p = min;
        for (int a = 0; a < D; ++a)
            if (corner_bits(i) >> a & 1) p[a] = max[a];
        return p;
    }
    /// The axes of which corner i takes the upper end, and back.
    static constexpr int corner_bits(int i) { return D == 2 && i >= 2 ? 5 - i : i; }
    std::array<Vec<D>, 1 << D> corners() const {
        std::array<Vec<D>, 1 << D> all;
        for (int i = 0; i < 1 << D; ++i) all[static_cast<std::size_t>(i)] = corner(i);
        return all;
    }
    /// Length of the longest side; 0 for an empty box.
    double longest_side() const {
        if (empty()) return 0;
        const Vec<D> e = extent();
        double side = 0;
        for (int i = 0; i < D; ++i) side = std::max(side, e[i]);
        return side;
    }
    void add(const Vec<D>& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    void add(const Box& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    bool contains(const Vec<D>& p) const {
        for (int i = 0; i < D; ++i)
            if (p[i] < min[i] || p[i] > max[i]) return false;
        return true;
    }
};

/// Of the nearest point of the box from p.
template <int D>
double squared_distance(const Box<D>& box, const Vec<D>& p) {
    double sum = 0;
    for (int i = 0; i < D; ++i) {
        const double away = std::max({box.min[i] - p[i], 0.0, p[i] - box.max[i]});
        sum += away * away;
    }
    return sum;
}

}  // namespace sightline
