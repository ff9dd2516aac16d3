// What a depth image says of a box.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sightline {

/// What a test says of a box: that nothing in it can cover a pixel; that nothing in it can change the image; neither.
enum class BoxSight : std::uint8_t { outside, hidden, seen };

}  // namespace sightline
