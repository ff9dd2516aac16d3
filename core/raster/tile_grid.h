// Images cut into tiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

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

}  // namespace sightline
