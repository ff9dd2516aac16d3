// A picture of pixels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/draw/draw_list.h"

namespace sightline {

/// Pixels by rows, the top row first.
struct Pixels {
    int width = 0, height = 0;
    std::vector<Colour> colours;

    const Colour& at(int x, int y) const {
        return colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// The same picture of so many pixels, > 0: each is the mean of those under it. The picture has some.
Pixels resized(const Pixels& pixels, int width, int height);

}  // namespace sightline
