// Triangles as floats, side by side in the order in which cells refer to them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/four_floats.h"
#include "core/base/large_pages.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace sightline {

/// A triangle as a cell that it meets knows it, in half a cache line: all that is needed to tell whether a view shows
/// it, except where that is close. Coordinates are relative to CellTriangles::origin().
struct CellTriangle {
    std::array<float, 3> centroid{};
    float radius = 0;             ///< the farthest corner's distance from the centroid, rounded up
    std::array<float, 3> area{};  ///< a vector as long as the area, on the side that is seen; 0 for needles
    std::uint32_t bits = 0;       ///< the primitive; the highest bit: it is seen from both sides

    std::uint32_t primitive() const { return bits & ~two_sided_bit; }
    bool two_sided() const { return bits & two_sided_bit; }

    static constexpr std::uint32_t two_sided_bit = 0x80000000u;
};
static_assert(sizeof(CellTriangle) == 32 && offsetof(CellTriangle, area) == 16);

/// Four that lie side by side.
struct FourTriangles {
    FourColumns at, area;

    explicit FourTriangles(const CellTriangle* t)
        : at(first_half(t), first_half(t + 1), first_half(t + 2), first_half(t + 3)),
          area(second_half(t), second_half(t + 1), second_half(t + 2), second_half(t + 3)) {}

    const FourFloats& radius() const { return at.w; }
    int two_sided() const { return area.w.signs(); }  ///< bit i: whether the i-th is

private:
    static const void* first_half(const CellTriangle* t) { return t; }
    static const void* second_half(const CellTriangle* t) { return reinterpret_cast<const char*>(t) + 16; }
};

/// Those of all cells: row i is that of CellComplex::cell_primitives[i].
class CellTriangles {
public:
    CellTriangles() = default;
    CellTriangles(const Scene<3>& scene, std::span<const std::uint32_t> references);

    const Vec<3>& origin() const { return origin_; }
    double reach() const { return reach_; }  ///< no corner is farther from the origin, on any axis
    std::span<const CellTriangle> rows() const { return std::span(rows_).first(rows_.size() - padding); }
    std::size_t memory_bytes() const { return rows_.capacity() * sizeof(CellTriangle); }

private:
    static constexpr std::size_t padding = 3;  ///< rows behind the last, so that four can be read at once

    Vec<3> origin_{0};
    double reach_ = 0;
    LargeVector<CellTriangle> rows_{padding};
};

/// What floats say of whether a view shows a triangle.
enum class Showing : std::uint8_t { no, unsure, yes };

/// A view in floats. `no` and `yes` are what faces(), two-sidedness and in_view() say for sure; unsure is what lies too
/// close to edge-on for floats, or across the border of the view.
class ShownFilter {
public:
    ShownFilter() = default;
    ShownFilter(const View<3>& view, const CellTriangles& triangles);

    Showing of(const CellTriangle& t) const {
        const std::array<CellTriangle, 4> four{t, t, t, t};
        return of_four(four.data()).at(0);
    }

    /// Of four, bit i for the i-th; with neither: unsure.
    struct Four {
        int no = 0, yes = 0;
        Showing at(std::size_t i) const {
            return no >> i & 1 ? Showing::no : yes >> i & 1 ? Showing::yes : Showing::unsure;
        }
    };
    /// The triangle and the three behind it.
    Four of_four(const CellTriangle* t) const {
        const FourTriangles four(t);
        const FourFloats &x = four.at.x, &y = four.at.y, &z = four.at.z, &a = four.area.x, &b = four.area.y,
                         &c = four.area.z;
        const FourFloats side = a * (eye_[0] - x) + b * (eye_[1] - y) + c * (eye_[2] - z);
        const FourFloats unsure = (abs(a) + abs(b) + abs(c)) * unsure_distance_ + tiny;
        FourFloats inside = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < 4; ++i) inside = lesser(inside, x_[i] * x + y_[i] * y + z_[i] * z - offset_[i]);
        // Beyond a plane with all of its corners; or with its centroid, and so with one of them, inside of each.
        const int two_sided = four.two_sided();
        const int away = (side < -unsure) & ~two_sided, out = inside < -(four.radius() + unsure_distance_);
        const int seen = (side > unsure) | two_sided, in = inside > unsure_distance_;
        return {away | out, seen & in};
    }

private:
    static constexpr float tiny = 1e-30f;  ///< more than products lose when they underflow
    std::array<float, 3> eye_{};
    float unsure_distance_ = std::numeric_limits<float>::infinity();
    std::array<float, 4> x_{}, y_{}, z_{}, offset_{};  ///< of the planes of the view; unit normals, inward
};

}  // namespace sightline
