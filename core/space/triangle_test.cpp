// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/triangle_test.h"

#include "core/space/tetrahedron.h"

namespace sightline {

namespace {

double largest(const Vec<3>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// How far two projections must lie apart to be surely disjoint. Let u = 2^-53 and S the largest coordinate relative to
/// the triangle's first corner: coordinates are off by at most u S, an axis (cross product of two differences) by 48 u
/// S^2 in each component of at most 8 S^2, and a projection of points that should share one (the ends of an edge that
/// the axis is perpendicular to) by 288 u S^3; computing the two projections adds less than 240 u S^3 each. The sum is
/// below 1024 u S^3; twice that is asked for. The last term covers underflow. Where a projection (at most 48 S^3) may
/// overflow, the margin does too: nothing counts as disjoint then.
double margin_for(double size) { return 64 * size * size * size * 0x1p-48 + 1e-300; }

/// The edges of a tetrahedron, each with the two corners that are not on it.
constexpr std::size_t tetrahedron_edges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                                                 {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};

bool disjoint(double low0, double high0, double low1, double high1, double margin) {
    return low0 - high1 > margin || low1 - high0 > margin;
}

}  // namespace

TriangleTest::TriangleTest(const Primitive<3>& t)
    : origin_(t[0]),
      corners_{Vec<3>(0), t[1] - t[0], t[2] - t[0]},
      edges_{corners_[1], corners_[2] - corners_[1], -corners_[2]},
      normal_(glm::cross(corners_[1], corners_[2])),
      size_(std::max(largest(corners_[1]), largest(corners_[2]))) {
    for (const Vec<3>& p : t) bounds_.add(p);
}

TriangleTest::Contact TriangleTest::with(const std::array<Vec<3>, 4>& tetrahedron) const {
    std::array<Vec<3>, 4> v;
    double size = size_;
    for (std::size_t i = 0; i < 4; ++i) {
        v[i] = tetrahedron[i] - origin_;
        size = std::max(size, largest(v[i]));
    }
    const double margin = margin_for(size);

    Contact contact;
    int corners_outside = 0;
    for (int i = 0; i < 4; ++i) {
        const Vec<3>&a = v[facet_corners[i][0]], &b = v[facet_corners[i][1]], &c = v[facet_corners[i][2]];
        const Vec<3> inward = glm::cross(b - a, c - a);
        const double plane = glm::dot(inward, a);
        double low = -plane, high = -plane;
        corners_outside |= low < 0;
        for (int j = 1; j < 3; ++j) {
            const double side = glm::dot(inward, corners_[j]) - plane;
            corners_outside |= (side < 0) << j;
            low = std::min(low, side);
            high = std::max(high, side);
        }
        if (-high > margin) return {};
        if (!(low > margin)) contact.reaches |= static_cast<std::uint8_t>(1 << i);
    }
    contact.meets = true;
    if (corners_outside != 7) return contact;  // one of them lies inside

    double low = glm::dot(normal_, v[0]), high = low;
    for (int i = 1; i < 4; ++i) {
        const double side = glm::dot(normal_, v[i]);
        low = std::min(low, side);
        high = std::max(high, side);
    }
    if (disjoint(low, high, 0, 0, margin)) return {};

    for (const auto& e : tetrahedron_edges) {
        const Vec<3> edge = v[e[1]] - v[e[0]];
        for (int j = 0; j < 3; ++j) {
            const Vec<3> axis = glm::cross(edge, edges_[j]);
            const double on0 = glm::dot(axis, v[e[0]]), off0 = glm::dot(axis, v[e[2]]), off1 = glm::dot(axis, v[e[3]]);
            const double on1 = glm::dot(axis, corners_[j]), off2 = glm::dot(axis, corners_[(j + 2) % 3]);
            if (disjoint(std::min({on0, off0, off1}), std::max({on0, off0, off1}), std::min(on1, off2),
                         std::max(on1, off2), margin))
                return {};
        }
    }
    return contact;
}

bool TriangleTest::meets(const Box<3>& box) const {
    for (int i = 0; i < 3; ++i)
        if (bounds_.min[i] > box.max[i] || bounds_.max[i] < box.min[i]) return false;
    const Vec<3> low = box.min - origin_, high = box.max - origin_;
    const double size = std::max({size_, largest(low), largest(high)}), margin = margin_for(size);
    const Vec<3> centre = (low + high) * 0.5, half = (high - low) * 0.5;
    const auto apart = [&](const Vec<3>& axis, double tri0, double tri1) {
        const double middle = glm::dot(axis, centre), reach = glm::dot(glm::abs(axis), half);
        return disjoint(middle - reach, middle + reach, std::min(tri0, tri1), std::max(tri0, tri1), margin);
    };
    if (apart(normal_, 0, 0)) return false;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            Vec<3> direction(0);
            direction[i] = size;
            const Vec<3> axis = glm::cross(direction, edges_[j]);
            if (apart(axis, glm::dot(axis, corners_[j]), glm::dot(axis, corners_[(j + 2) % 3]))) return false;
        }
    return true;
}

}  // namespace sightline
