// Which pixels of the exact image a frame misses (TVCG fig. 14).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/draw/pixels.h"
#include "core/measure/reference.h"

namespace sightline {

/// Right pixels white, wrong ones red: those whose primitive is not among the `touched` ones (State::touched) that are
/// rendered. As large as the reference's image.
Pixels wrong_picture(const Reference& reference, std::span<const std::uint32_t> touched);

}  // namespace sightline
