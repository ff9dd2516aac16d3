// Triangles as floats, side by side in the order in which cells refer to them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

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
static_assert(sizeof(CellTriangle) == 32);

/// Those of all cells: row i is that of CellComplex::cell_primitives[i].
class CellTriangles {
public:
    CellTriangles() = default;
    CellTriangles(const Scene<3>& scene, std::span<const std::uint32_t> references);

    const Vec<3>& origin() const { return origin_; }
    double reach() const { return reach_; }  ///< no corner is farther from the origin, on any axis
    std::span<const CellTriangle> rows() const { return rows_; }
    std::size_t memory_bytes() const { return rows_.capacity() * sizeof(CellTriangle); }

private:
    Vec<3> origin_{0};
    double reach_ = 0;
    std::vector<CellTriangle> rows_;
};

/// What floats say of whether a view shows a triangle.
enum class Shown : std::uint8_t { no, unsure, yes };

/// A view in floats. `no` and `yes` are what faces(), two-sidedness and in_view() say for sure; unsure is what lies too
/// close to edge-on for floats, or across the border of the view.
class ShownFilter {
public:
    ShownFilter() = default;
    ShownFilter(const View<3>& view, const CellTriangles& triangles);

    Shown of(const CellTriangle& t) const {
        bool sure = true;
        if (!t.two_sided()) {
            const float side = t.area[0] * (eye_[0] - t.centroid[0]) + t.area[1] * (eye_[1] - t.centroid[1]) +
                               t.area[2] * (eye_[2] - t.centroid[2]);
            const float unsure =
                (std::abs(t.area[0]) + std::abs(t.area[1]) + std::abs(t.area[2])) * unsure_distance_ + tiny;
            if (side < -unsure) return Shown::no;
            sure = side > unsure;
        }
        std::array<float, 4> inside;
        for (std::size_t i = 0; i < 4; ++i)
            inside[i] = x_[i] * t.centroid[0] + y_[i] * t.centroid[1] + z_[i] * t.centroid[2] - offset_[i];
        const float least = std::min(std::min(inside[0], inside[1]), std::min(inside[2], inside[3]));
        // Beyond a plane with all of its corners; or with its centroid, and so with one of them, inside of each.
        if (least < -(t.radius + unsure_distance_)) return Shown::no;
        return sure && least > unsure_distance_ ? Shown::yes : Shown::unsure;
    }

private:
    static constexpr float tiny = 1e-30f;  ///< more than products lose when they underflow
    std::array<float, 3> eye_{};
    float unsure_distance_ = std::numeric_limits<float>::infinity();
    std::array<float, 4> x_{}, y_{}, z_{}, offset_{};  ///< of the planes of the view; unit normals, inward
};

/// The triangles of a cell complex, made when they are first asked for. Any thread may ask.
class LazyCellTriangles {
public:
    const CellTriangles& of(const Scene<3>& scene, std::span<const std::uint32_t> references) const {
        std::call_once(once_, [&] { triangles_ = CellTriangles(scene, references); });
        return triangles_;
    }

private:
    mutable std::once_flag once_;
    mutable CellTriangles triangles_;
};

}  // namespace sightline
