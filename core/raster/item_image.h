// Item buffers: shapes drawn with their numbers where they lie before all that is drawn, and tiles to read them by.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster/pixel_line.h"
#include "core/raster/query.h"

namespace sightline {

/// Pixels [left, right) x [top, bottom); along a line of pixels one row.
struct Tile {
    int left = 0, top = 0, right = 0, bottom = 0;
    std::uint32_t pixels() const { return static_cast<std::uint32_t>((right - left) * (bottom - top)); }
};

/// An image cut into tiles of 64 x 64 pixels, a line into runs of 64, row by row; those at the end may be smaller.
struct TileGrid {
    static constexpr int side = 64;
    int width = 0, height = 0;  ///< in pixels

    int columns() const { return (width + side - 1) / side; }
    int rows() const { return (height + side - 1) / side; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(columns() * rows()); }
    Tile tile(std::uint32_t i) const {
        const int x = static_cast<int>(i) % columns() * side, y = static_cast<int>(i) / columns() * side;
        return {x, y, std::min(x + side, width), std::min(y + side, height)};
    }
};
inline TileGrid tiles_of(const PixelLine& line) { return {line.width(), 1}; }
inline TileGrid tiles_of(const DepthImage& image) { return {image.width, image.height}; }

/// Which shape a pixel shows that several lie before all that is drawn. Of equally near ones the first.
enum class ItemWins : std::uint8_t { nearest, last };

// Shapes lie before what is drawn as in queries: conservatively. One that is everywhere lies there at every pixel, as
// near as can be; with ItemWins::nearest though it only shows where no other does, so that it hides none.

/// Per pixel the index of the shape that it shows, or none.
std::vector<std::uint32_t> draw_items(std::span<const LineShape> shapes, const PixelLine& line, ItemWins wins);
std::vector<std::uint32_t> draw_items(std::span<const SeenShape> shapes, const DepthImage& image,
                                      const DepthPyramid& pyramid, ItemWins wins);

/// Whether one of the shapes might lie before what is drawn at a pixel of the tile if it were widened a little more
/// than queries do. Where none does, all that lies in front of what is drawn there is already drawn, and nothing that
/// comes later can show there.
bool tile_may_show(std::span<const LineShape> shapes, const PixelLine& line, const Tile& tile);
bool tile_may_show(std::span<const SeenShape> shapes, const DepthImage& image, const Tile& tile);

}  // namespace sightline
