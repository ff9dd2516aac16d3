// The history of one pixel: what lies behind it, from near to far, and when each was rendered.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/session/session.h"

namespace sightline {

/// A triangle that turns a seen side to the eye and is hit by the ray through the pixel's centre.
struct PixelLayer {
    std::uint32_t primitive = none;
    double distance = 0;       ///< from the eye, scene units
    std::uint32_t met_at = 0;  ///< the recorded step, done or to come, that renders it; 0: none does
};

struct PixelHistory {
    int x = 0, y = 0;                 ///< from the left and the top
    std::uint32_t should_own = none;  ///< the exact image shows it; none: nothing is there
    std::uint32_t owns = none;        ///< the nearest that is rendered at the session's position
    std::vector<PixelLayer> layers;   ///< nearest first
    bool tie = false;                 ///< those two differ, and lie equally near as far as single precision tells
};

/// Of a pixel of the reference's image. Cost: primitives + steps. Throws InputError for a pixel outside the image.
PixelHistory pixel_history(const Session<3>& session, int x, int y);

}  // namespace sightline
