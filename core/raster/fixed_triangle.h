// A triangle on the raster's grid of 256 places a pixel: which pixels it covers is decided in whole numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/raster/image_triangles.h"

namespace sightline {

/// Places a pixel. A snapped corner lies at most half a place off in x and in y: sqrt(2) / 512 of a pixel.
constexpr int subpixels = 256;

/// The largest side of an image in pixels. Corners then lie within 2^23 places, and edge functions within 2^51, so
/// that doubles hold them exactly too.
constexpr int largest_raster = 16384;

/// Corners in places from the left top of the image, y downwards; corner 0 is the farthest, and the three turn so that
/// `area` is positive.
struct FixedTriangle {
    std::array<std::int32_t, 3> x{}, y{};
    std::array<float, 3> nearness{};
    std::uint32_t id = 0;

    /// Positive on the inner side of the edge from corner i to the next one, 0 on its line.
    std::int64_t edge(int i, std::int64_t px, std::int64_t py) const {
        const int j = (i + 1) % 3;
        return (std::int64_t{x[j]} - x[i]) * (py - y[i]) - (std::int64_t{y[j]} - y[i]) * (px - x[i]);
    }
    std::int64_t area() const { return edge(0, x[2], y[2]); }  ///< twice
    /// Whether a point on edge i belongs to the triangle (top-left rule): of two that share the edge, to one.
    bool owns_edge(int i) const {
        const int j = (i + 1) % 3;
        return y[j] < y[i] || (y[j] == y[i] && x[j] > x[i]);
    }
};

/// The first pixel of a row or column whose centre lies at that place or beyond.
constexpr std::int32_t first_centre(std::int32_t place) {
    return (place - subpixels / 2 + subpixels - 1) >> 8;  // rounds up, also below 0
}

/// Puts corners into their order. False when no area is left.
inline bool turn(FixedTriangle& triangle) {
    const std::int64_t area = triangle.area();
    if (area == 0) return false;
    const auto swap = [&](std::size_t i, std::size_t j) {
        std::swap(triangle.x[i], triangle.x[j]);
        std::swap(triangle.y[i], triangle.y[j]);
        std::swap(triangle.nearness[i], triangle.nearness[j]);
    };
    if (area < 0) swap(1, 2);
    const auto& n = triangle.nearness;
    if (n[1] < n[0] && n[1] <= n[2])
        swap(0, 1), swap(1, 2);
    else if (n[2] < n[0])
        swap(0, 2), swap(1, 2);
    return true;
}

/// The pixels whose centres lie in the box of a triangle, cut to the image.
struct PixelBox {
    std::int32_t left, top, right, bottom;  ///< [left, right) x [top, bottom)

    PixelBox(const FixedTriangle& t, const ImageSize& size)
        : left(std::max(first_centre(std::min({t.x[0], t.x[1], t.x[2]})), 0)),
          top(std::max(first_centre(std::min({t.y[0], t.y[1], t.y[2]})), 0)),
          right(std::min(first_centre(std::max({t.x[0], t.x[1], t.x[2]})), size.width)),
          bottom(std::min(first_centre(std::max({t.y[0], t.y[1], t.y[2]})), size.height)) {}
    bool empty() const { return left >= right || top >= bottom; }
};

/// Snaps the triangle at `corners`. False when it covers no pixel: no area is left, or no centre of a pixel of the
/// image lies in its box.
inline bool snap_triangle(const ImageCorner* corners, const ImageSize& size, FixedTriangle& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.x[i] =
            static_cast<std::int32_t>(std::floor((corners[i].x + 1.0) * (0.5 * subpixels * size.width) + 0.5));
        triangle.y[i] =
            static_cast<std::int32_t>(std::floor((corners[i].y + 1.0) * (0.5 * subpixels * size.height) + 0.5));
        triangle.nearness[i] = corners[i].nearness;
    }
    triangle.id = corners[0].id;
    // A right or bottom border that runs through centres does not own them.
    return !PixelBox(triangle, size).empty() && turn(triangle);
}

/// Which pixels of each row a triangle covers, exactly: those whose centres lie inside, or on an edge that it owns.
/// Shrunk: those whose whole square lies inside, `margin` places away from its edges.
struct CoveredRows {
    std::int32_t first_row = 0, end_row = 0;  ///< in the image

    CoveredRows(const FixedTriangle& t, const ImageSize& size, bool shrunk = false, int margin = 0) {
        first_row = std::max(first_centre(std::min({t.y[0], t.y[1], t.y[2]})), 0);
        end_row = std::min(first_centre(std::max({t.y[0], t.y[1], t.y[2]})), size.height);
        width_ = size.width;
        int lefts = 0, rights = 0;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const std::int64_t dx = std::int64_t{t.x[j]} - t.x[i], dy = std::int64_t{t.y[j]} - t.y[i];
            // What the edge function at a centre must reach.
            std::int64_t least = t.owns_edge(i) ? 0 : 1;
            if (shrunk) least = (subpixels / 2 + margin) * (std::abs(dx) + std::abs(dy));
            if (dy == 0) {
                // Level: the rows of the box are right already, but for the margin.
                if (shrunk) cut_rows(dx > 0, t.y[i], subpixels / 2 + margin);
                continue;
            }
            Line& line = dy < 0 ? left_[lefts++] : right_[rights++];
            line = {static_cast<double>(dx * (subpixels / 2 - t.y[i]) - dy * (subpixels / 2 - t.x[i]) - least),
                    static_cast<double>(dx * subpixels), static_cast<double>(std::abs(dy) * subpixels)};
        }
        if (lefts == 1) left_[1] = left_[0];
        if (rights == 1) right_[1] = right_[0];
    }

    /// Pixels [first, end) of the row; empty when end <= first.
    void span(std::int32_t row, std::int32_t& first, std::int32_t& end) const {
        // In doubles, since their division is quick: the quotient of whole numbers below 2^51 by one below 2^32 that is
        // not whole itself lies too far from a whole number for rounding to reach it, where it lies in the image.
        const double y = row;
        const double left = std::min(left_[0].steps(y), left_[1].steps(y));
        const double right = std::min(right_[0].steps(y), right_[1].steps(y));
        first = -rounded_down(std::max(left, -double{largest_raster}));
        end = 1 + rounded_down(std::max(right, -1.0));
        first = std::max(first, 0);
        end = std::min(end, width_);
    }

    /// The same of rows [row, row + 8) at once, where vectors can do it.
    static constexpr int rows_at_once = 8;
    using Columns = std::array<std::int32_t, rows_at_once>;
    [[gnu::always_inline]] void spans(std::int32_t row, Columns& first, Columns& end) const {
        for (int i = 0; i < rows_at_once; ++i) {
            const double y = row + i;
            const double left = std::min(left_[0].steps(y), left_[1].steps(y));
            const double right = std::min(right_[0].steps(y), right_[1].steps(y));
            constexpr double most = largest_raster;
            const double from = -std::floor(std::min(std::max(left, -most), most));
            const double to = 1 + std::floor(std::min(std::max(right, -1.0), most));
            first[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(std::max(from, 0.0));
            end[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(std::min(to, static_cast<double>(width_)));
        }
    }

private:
    /// An edge's function at the centre of pixel 0 of row 0 (less what it must reach), its change from row to row, and
    /// from pixel to pixel.
    struct Line {
        double at = 0, per_row = 0, per_pixel = 1;
        double steps(double row) const { return (at + per_row * row) / per_pixel; }
    };

    static std::int32_t rounded_down(double q) {
        q = std::min(q, double{largest_raster});
        const auto whole = static_cast<std::int32_t>(q);
        return whole - (q < whole);
    }
    void cut_rows(bool top, std::int32_t y, std::int32_t distance) {
        if (top)
            first_row = std::max(first_row, first_centre(y + distance));
        else
            end_row = std::min(end_row, first_centre(y - distance + 1));
    }

    std::int32_t width_ = 0;
    std::array<Line, 2> left_, right_;
};

/// Nearness as a function of the pixel: a mean of the corners' with weights that are whole numbers over the area. All
/// terms are positive, so that rounding stays below 2^-50 of the result however thin the triangle is.
class NearnessPlane {
public:
    explicit NearnessPlane(const FixedTriangle& t) {
        const double area = static_cast<double>(t.area());
        far_ = t.nearness[0];
        for (std::size_t k = 0; k < 2; ++k) {
            const int edge = k == 0 ? 2 : 0;  // opposite corners 1 and 2
            const int i = edge, j = (edge + 1) % 3;
            const std::int64_t dx = std::int64_t{t.x[j]} - t.x[i], dy = std::int64_t{t.y[j]} - t.y[i];
            at_[k] = static_cast<double>(t.edge(edge, subpixels / 2, subpixels / 2));
            per_row_[k] = static_cast<double>(dx * subpixels);
            per_pixel_[k] = static_cast<double>(-dy * subpixels);
            rise_[k] = (static_cast<double>(t.nearness[k + 1]) - far_) / area;
        }
    }

    /// The same along one row: at(first + i) for i = 0, 1, …
    struct Row {
        double far, weight1, weight2, step1, step2, rise1, rise2;
        [[gnu::always_inline]] double at(double i) const {
            return far + ((weight1 + step1 * i) * rise1 + (weight2 + step2 * i) * rise2);
        }
    };
    Row row(std::int32_t row, std::int32_t first) const {
        return {far_,
                at_[0] + per_row_[0] * row + per_pixel_[0] * first,
                at_[1] + per_row_[1] * row + per_pixel_[1] * first,
                per_pixel_[0],
                per_pixel_[1],
                rise_[0],
                rise_[1]};
    }
    /// How much it changes within half a pixel in x and y.
    double half_pixel() const {
        return 0.5 * (std::abs(per_pixel_[0] * rise_[0] + per_pixel_[1] * rise_[1]) +
                      std::abs(per_row_[0] * rise_[0] + per_row_[1] * rise_[1]));
    }

private:
    double far_ = 0;
    std::array<double, 2> at_{}, per_row_{}, per_pixel_{}, rise_{};
};

}  // namespace sightline
