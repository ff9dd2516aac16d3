// The picture of the pixels that a budget leaves wrong (TVCG fig. 14).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/draw/pixels.h"
#include "core/run/drawn.h"
#include "core/truth/reference.h"

namespace sightline {

/// Of the size of the reference's image: white where it shows nothing or a primitive that
/// was rendered, red elsewhere. The share of red pixels is wrong_pixels (metrics.h).
Pixels wrong_picture(const Reference& reference, std::span<const Met> met);

}  // namespace sightline
