// The picture of the pixels that a budget leaves wrong (TVCG fig. 14).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/draw/pixels.h"
#include "core/run/drawn.h"
#include "core/truth/reference.h"

namespace sightline {

/// Of the size of the reference's image: red where it shows a primitive that was not rendered, white where it shows
/// nothing, elsewhere a pale ghost of what is there; shades tell its surfaces apart. The share of red pixels is
/// wrong_pixels (metrics.h).
Pixels wrong_picture(const Reference& reference, std::span<const Met> met, const Scene<3>& scene);

}  // namespace sightline
