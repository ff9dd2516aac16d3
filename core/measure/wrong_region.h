// How the wrong pixels of a frame hang together: a missing wall is worse than as many specks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/truth/id_image.h"

namespace sightline {

/// Per pixel 1 where the exact image shows a primitive that is not rendered. `rendered`: per primitive, 1 or 0.
std::vector<std::uint8_t> wrong_mask(const IdImage& exact, std::span<const std::uint8_t> rendered);

/// Pixels of the largest region of ones that hang together by their sides. mask: width x height, by rows.
std::size_t largest_region(std::span<const std::uint8_t> mask, int width, int height);

}  // namespace sightline
