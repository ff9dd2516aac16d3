// From a corner of a cell towards the eye: the cell that the ray goes through first, and where it leaves it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/large_pages.h"
#include "core/run/cell_contents.h"
#include "core/run/problem.h"

namespace sightline {

template <int D>
struct CornerRay {
    static constexpr std::size_t most_corners = std::size_t{1} << (D - 1);

    std::uint32_t cell = none;  ///< that it goes through; none: it leaves the tessellation at once
    bool ends = false;          ///< the eye lies in that cell
    Vec<D> to_eye{};            ///< from the middle of that cell
    std::uint32_t count = 0;    ///< of the corners of the facet (boxes: of the side) that it leaves the cell through
    std::array<std::uint32_t, most_corners> corners{};
    std::array<float, most_corners> weights{};  ///< of the point where it leaves; they add up to 1
};

/// What all views of a tessellation share.
template <int D>
class CornerRays {
public:
    CornerRays() = default;
    explicit CornerRays(const CellComplex<D>& cells);

    /// Of boxes no ray leads back to where another began, since a plane of the tree lies between. That simplices are no
    /// worse, corners that are no closer to the eye than `corner` are left out of the weights.
    CornerRay<D> from(const CellComplex<D>& cells, std::uint32_t corner, const Vec<D>& eye) const {
        return cells.has_boxes() ? through_box(corner, eye) : through_simplex(cells, corner, eye);
    }
    // What asks for memory ahead changes nothing else: first for the corner, then, when it has come, for what from()
    // reads next. Returns the cell that the ray goes through, or none where that is not known yet.

    void prefetch(std::uint32_t corner) const {
        if (!points_.empty()) detail::prefetch(&points_[corner]);
    }
    std::uint32_t prefetch_cell(std::uint32_t corner, const Vec<D>& eye) const {
        if (points_.empty()) return none;
        const std::uint32_t cell = points_[corner].cells[upwards(points_[corner], eye)];
        if (cell != none) detail::prefetch(&boxes_[cell]);
        return cell;
    }

private:
    // Boxes are relative to the middle of the tree. Floats that are rounded from the same numbers lie in their order.

    struct alignas(D == 2 ? 32 : 64) Point {
        std::array<float, D> at{};
        std::array<std::uint32_t, 1 << D> cells{};  ///< around it; bit i of a place: upwards along axis i
    };
    struct alignas(D == 2 ? 32 : 64) CellBox {
        std::array<float, D> min{}, max{};
        std::array<std::uint32_t, 1 << D> corners{};  ///< bit i of a place: the upper end of axis i
    };

    /// Bit i: whether the eye lies no lower along axis i.
    std::size_t upwards(const Point& p, const Vec<D>& eye) const {
        std::size_t bits = 0;
        for (std::size_t i = 0; i < D; ++i) bits |= std::size_t{!(along(p, eye, i) < 0)} << i;
        return bits;
    }
    float along(const Point& p, const Vec<D>& eye, std::size_t axis) const {
        const int i = static_cast<int>(axis);
        return static_cast<float>(eye[i] - origin_[i]) - p.at[axis];
    }

    void set_boxes(const CellComplex<D>& cells);
    CornerRay<D> through_box(std::uint32_t corner, const Vec<D>& eye) const;
    CornerRay<D> through_simplex(const CellComplex<D>& cells, std::uint32_t corner, const Vec<D>& eye) const;

    Vec<D> origin_{};
    LargeVector<Point> points_;
    LargeVector<CellBox> boxes_;

    // Of simplices.

    std::vector<std::uint32_t> begin_, cells_;  ///< cells around point i: from begin_[i] on
    std::vector<std::uint8_t> outside_;         ///< whether a point lies at the border of the tessellation
};

/// Made once for the cells of the problem.
template <int D>
std::shared_ptr<const CornerRays<D>> corner_rays(const Problem<D>& problem);

}  // namespace sightline
