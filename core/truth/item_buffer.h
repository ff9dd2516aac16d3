// The papers' reference in 2D: a one-dimensional item buffer (TR section 4, TVCG section 4.4).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/truth/visible_set.h"

namespace sightline {

/// One primitive id per pixel, none where nothing is seen; pixel 0 is at the right border of the view. The
/// pixels are evenly spread over the image line of a perspective camera and sampled at their centres; an all-round
/// view has four such lines of width / 4 pixels, facing +x, +y, -x, -y, each from its right to its left border.
/// On equal depth the lowest id wins.
struct ItemBuffer {
    std::vector<std::uint32_t> ids;
};

/// `width` in pixels, in [1, 2^24] (for an all-round view a multiple of 4); throws InputError otherwise.
ItemBuffer item_buffer(std::span<const Primitive<2>> primitives, const View<2>& view, int width);

/// 1 per primitive that owns at least one pixel.
std::vector<std::uint8_t> visible_in(const ItemBuffer& buffer, std::size_t primitive_count);

}  // namespace sightline
