// Triangles as floats, side by side in the order in which cells refer to them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

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
static_assert(sizeof(CellTriangle) == 32);

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
#if defined(__SSE__)
    Four of_four(const CellTriangle* t) const {
        __m128 x = _mm_loadu_ps(&t[0].centroid[0]), y = _mm_loadu_ps(&t[1].centroid[0]),
               z = _mm_loadu_ps(&t[2].centroid[0]), radius = _mm_loadu_ps(&t[3].centroid[0]);
        _MM_TRANSPOSE4_PS(x, y, z, radius);
        __m128 a = _mm_loadu_ps(&t[0].area[0]), b = _mm_loadu_ps(&t[1].area[0]), c = _mm_loadu_ps(&t[2].area[0]),
               bits = _mm_loadu_ps(&t[3].area[0]);
        _MM_TRANSPOSE4_PS(a, b, c, bits);
        const auto one = [](float value) { return _mm_set1_ps(value); };
        const auto sum = [](__m128 p, __m128 q, __m128 r) { return _mm_add_ps(_mm_add_ps(p, q), r); };

        const __m128 side = sum(_mm_mul_ps(a, _mm_sub_ps(one(eye_[0]), x)), _mm_mul_ps(b, _mm_sub_ps(one(eye_[1]), y)),
                                _mm_mul_ps(c, _mm_sub_ps(one(eye_[2]), z)));
        const __m128 sign = one(-0.0f), distance = one(unsure_distance_);
        const __m128 size = sum(_mm_andnot_ps(sign, a), _mm_andnot_ps(sign, b), _mm_andnot_ps(sign, c));
        const __m128 unsure = _mm_add_ps(_mm_mul_ps(size, distance), one(tiny));
        __m128 least = one(std::numeric_limits<float>::infinity());
        for (std::size_t i = 0; i < 4; ++i)
            least = _mm_min_ps(
                least, _mm_sub_ps(sum(_mm_mul_ps(one(x_[i]), x), _mm_mul_ps(one(y_[i]), y), _mm_mul_ps(one(z_[i]), z)),
                                  one(offset_[i])));
        // Beyond a plane with all of its corners; or with its centroid, and so with one of them, inside of each.
        const int two_sided = _mm_movemask_ps(bits);
        const int away = _mm_movemask_ps(_mm_cmplt_ps(side, _mm_xor_ps(sign, unsure))) & ~two_sided;
        const int out = _mm_movemask_ps(_mm_cmplt_ps(least, _mm_xor_ps(sign, _mm_add_ps(radius, distance))));
        const int seen = _mm_movemask_ps(_mm_cmpgt_ps(side, unsure)) | two_sided;
        const int in = _mm_movemask_ps(_mm_cmpgt_ps(least, distance));
        return {away | out, seen & in};
    }
#else
    /// The same sums, one triangle after the other.
    Four of_four(const CellTriangle* t) const {
        Four four;
        for (int i = 0; i < 4; ++i) {
            const auto& [x, y, z] = t[i].centroid;
            const auto& [a, b, c] = t[i].area;
            const float side = a * (eye_[0] - x) + b * (eye_[1] - y) + c * (eye_[2] - z);
            const float unsure = (std::abs(a) + std::abs(b) + std::abs(c)) * unsure_distance_ + tiny;
            float least = std::numeric_limits<float>::infinity();
            for (std::size_t k = 0; k < 4; ++k) {
                const float inside = x_[k] * x + y_[k] * y + z_[k] * z - offset_[k];
                least = least < inside ? least : inside;
            }
            const bool away = side < -unsure && !t[i].two_sided(), out = least < -(t[i].radius + unsure_distance_);
            four.no |= (away || out) << i;
            four.yes |= ((side > unsure || t[i].two_sided()) && least > unsure_distance_) << i;
        }
        return four;
    }
#endif

private:
    static constexpr float tiny = 1e-30f;  ///< more than products lose when they underflow
    std::array<float, 3> eye_{};
    float unsure_distance_ = std::numeric_limits<float>::infinity();
    std::array<float, 4> x_{}, y_{}, z_{}, offset_{};  ///< of the planes of the view; unit normals, inward
};

}  // namespace sightline
