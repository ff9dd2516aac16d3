// How the wrong pixels of a frame hang together: a missing wall is worse than as many specks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/truth/id_image.h"

namespace sightline {

/// Per pixel 1 where the exact image shows a primitive that is not rendered. `rendered`: per primitive, 1 or 0.
std::vector<std::uint8_t> wrong_mask(const IdImage& exact, std::span<const std::uint8_t> rendered);

/// Pixels of the largest region of ones that hang together by their sides. mask: width x height, by rows.
std::size_t largest_region(std::span<const std::uint8_t> mask, int width, int height);

/// A primitive and how many pixels of something are its.
struct PixelCount {
    std::uint32_t primitive = none;
    std::uint32_t pixels = 0;
    bool operator==(const PixelCount&) const = default;
};

/// Wrong pixels that hang together by their sides.
struct WrongRegion {
    std::uint32_t pixels = 0;
    std::array<int, 4> box{};            ///< first and last column, first and last row, from the top
    std::vector<PixelCount> primitives;  ///< whose pixels they should be: most pixels first, then by id
};

/// All of them, the largest first, then by their first pixel. `wrong` as wrong_mask.
std::vector<WrongRegion> wrong_regions(const IdImage& exact, std::span<const std::uint8_t> wrong);

}  // namespace sightline
