// Item buffers: shapes drawn with their numbers where they lie before all that is drawn, and tiles to read them by.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster/pixel_line.h"
#include "core/raster/query.h"
#include "core/raster/tile_grid.h"

namespace sightline {

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
