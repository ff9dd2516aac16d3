// What of a segment or a triangle lies inside a convex region; rounded.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/geometry/vec.h"

namespace sightline {

/// What lies on the side of a plane to which its normal points. By a point of it, not by its distance from the origin,
/// so that a scene far from the origin loses no more digits than its coordinates.
template <int D>
struct HalfSpace {
    Vec<D> normal{}, on{};
    /// Positive inside; in lengths of the normal.
    double at(const Vec<D>& p) const { return glm::dot(normal, p - on); }
};

/// A box, a triangle or a tetrahedron as what its sides have in common.
template <int D>
class HalfSpaces {
public:
    HalfSpaces() = default;
    explicit HalfSpaces(const Box<D>& box) {
        for (int i = 0; i < D; ++i) {
            Vec<D> normal(0);
            normal[i] = 1;
            add(normal, box.min);
            add(-normal, box.max);
        }
    }
    /// At most six.
    void add(const Vec<D>& normal, const Vec<D>& on) { sides_[count_++] = {normal, on}; }
    std::span<const HalfSpace<D>> all() const { return std::span(sides_).first(count_); }

private:
    std::array<HalfSpace<D>, 6> sides_;
    std::size_t count_ = 0;
};

/// The share of the segment that lies inside, in [0, 1].
template <int D>
double share_inside(const HalfSpaces<D>& region, const Vec<D>& from, const Vec<D>& to) {
    double begin = 0, end = 1;
    for (const HalfSpace<D>& side : region.all()) {
        const double a = side.at(from), b = side.at(to);
        if (a < 0 && b < 0) return 0;
        if (a < 0)
            begin = std::max(begin, a / (a - b));
        else if (b < 0)
            end = std::min(end, a / (a - b));
    }
    return std::max(0.0, end - begin);
}

/// Length of the part of the segment that lies inside.
inline double size_inside(const HalfSpaces<2>& region, const std::array<Vec<2>, 2>& segment) {
    const Vec<2> way = segment[1] - segment[0];
    return share_inside(region, segment[0], segment[1]) * std::sqrt(glm::dot(way, way));
}

/// Area of the part of the triangle that lies inside (Sutherland and Hodgman: a side adds one corner at most).
inline double size_inside(const HalfSpaces<3>& region, const std::array<Vec<3>, 3>& triangle) {
    std::array<Vec<3>, 9> polygon{triangle[0], triangle[1], triangle[2]}, cut;
    std::size_t count = 3;
    for (const HalfSpace<3>& side : region.all()) {
        std::array<double, 9> at;
        bool any_out = false;
        for (std::size_t i = 0; i < count; ++i) any_out |= (at[i] = side.at(polygon[i])) < 0;
        if (!any_out) continue;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count && kept + 1 < cut.size(); ++i) {
            const std::size_t next = i + 1 == count ? 0 : i + 1;
            if (at[i] >= 0) cut[kept++] = polygon[i];
            if ((at[i] < 0) != (at[next] < 0))
                cut[kept++] = polygon[i] + (polygon[next] - polygon[i]) * (at[i] / (at[i] - at[next]));
        }
        if (kept < 3) return 0;
        polygon = cut;
        count = kept;
    }
    Vec<3> twice(0);
    for (std::size_t i = 1; i + 1 < count; ++i)
        twice += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return std::sqrt(glm::dot(twice, twice)) / 2;
}

/// Of a convex region.
struct ConvexSize {
    double inside = 0;   ///< volume; 2D: area
    double surface = 0;  ///< area of it; 2D: length of the border

    /// How many pieces of that area (2D: length) inside it a line through it meets in the mean, if they are turned in
    /// all directions alike (Cauchy, Crofton); 0 for a region without a surface.
    double depth_of(double held) const { return surface > 0 ? 2 * held / surface : 0; }
    /// Mean length of such a line inside: 4 volume / surface, 2D: π area / border.
    template <int D>
    double mean_chord() const {
        constexpr double factor = D == 2 ? 3.14159265358979323846 : 4;
        return surface > 0 ? factor * inside / surface : 0;
    }
};

inline ConvexSize size_of(const Box<2>& box) {
    const Vec<2> e = box.extent();
    return {e.x * e.y, 2 * (e.x + e.y)};
}
inline ConvexSize size_of(const Box<3>& box) {
    const Vec<3> e = box.extent();
    return {e.x * e.y * e.z, 2 * (e.x * e.y + e.y * e.z + e.z * e.x)};
}

}  // namespace sightline
