// The picture of the pixels that a budget leaves wrong (TVCG fig. 14).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/draw/pixels.h"
#include "core/truth/reference.h"

namespace sightline {

/// Of the size of the reference's image: red where `wrong` (1 per wrong pixel, as Session::wrong_mask) says so, white
/// where it shows nothing, elsewhere a pale ghost of what is there; shades tell its surfaces apart.
Pixels wrong_picture(const Reference& reference, std::span<const std::uint8_t> wrong, const Scene<3>& scene);

}  // namespace sightline
