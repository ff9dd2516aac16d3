// Depth and ids along a line of pixels: what an eye in the plane sees of segments, and occlusion queries against it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/view.h"
#include "core/space/cell_complex.h"

namespace sightline {

/// Pixel 0 is at the right border of the view. The pixels are evenly spread over the image line of a perspective camera
/// and sampled at their centres; an all-round view has four such lines of width / 4 pixels, facing +x, +y, -x, -y, each
/// from its right to its left border.
struct PixelLine {
    std::vector<double> nearness;    ///< one over the depth, in units of the image line's; 0: nothing is there
    std::vector<std::uint32_t> ids;  ///< none: nothing

    PixelLine() = default;
    /// Throws InputError unless the width is in [1, 2^24], and for an all-round view a multiple of 4.
    PixelLine(const View<2>& view, int width);
    int width() const { return static_cast<int>(ids.size()); }
    bool operator==(const PixelLine&) const = default;
};

/// The pixels of a line that is to have `width`: all round it has a multiple of 4.
inline int whole_line_width(const View<2>& view, int width) {
    return view.all_round ? std::max(4, width / 4 * 4) : width;
}

/// Draws segments over what is there already, in any order: all, or those of the list. On equal depth the lowest id
/// wins.
void draw_line(PixelLine& line, std::span<const Primitive<2>> segments, const View<2>& view);
void draw_line(PixelLine& line, std::span<const Primitive<2>> segments, const View<2>& view,
               std::span<const std::uint32_t> which);
/// The same, in the list's order; won[i] is set to 1 where segment i of the list covers a pixel that nothing before it
/// has nearer, else to 0.
void draw_line(PixelLine& line, std::span<const Primitive<2>> segments, const View<2>& view,
               std::span<const std::uint32_t> which, std::span<std::uint8_t> won);

/// A convex cell as a line of pixels may see it: the pixels that it covers, widened by 1/128 pixel, and no less near
/// than what lies in it.
struct LineShape {
    struct Piece {
        int first = 0, end = 0;  ///< pixels
        double nearness_0 = 0, nearness_x = 0, nearest = 0;
        double nearness(int x) const { return std::min(nearest, nearness_0 + nearness_x * x); }
    };
    std::vector<Piece> pieces;
    bool everywhere = false;  ///< the eye lies in it
};
LineShape seen_cell(const View<2>& view, int width, const CellComplex<2>& cells, std::uint32_t cell);
/// Corners in either order around it; two: a segment.
LineShape seen_polygon(const View<2>& view, int width, std::span<const Vec<2>> corners);

struct LineSight {
    std::uint32_t pixels = 0;  ///< that the shape covers, seen or not
    std::uint32_t seen = 0;
    std::optional<int> witness;            ///< the first that shows it
    std::vector<std::uint32_t> hidden_by;  ///< ascending: the segments at the others
};
LineSight look_at(const LineShape& shape, const PixelLine& line);
/// Its witness, without the rest.
std::optional<int> find_seen(const LineShape& shape, const PixelLine& line);

}  // namespace sightline
