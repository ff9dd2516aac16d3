// Where the window stands on the screen.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace sightline {

/// In screen units, which may be several pixels.
struct Placement {
    int width = 0, height = 0;             ///< 0: the usual size, as large as the screen's density asks
    std::optional<std::array<int, 2>> at;  ///< its upper left corner; nothing: where the window system puts it
    bool maximised = false;
    bool operator==(const Placement&) const = default;
};

inline constexpr int usual_width = 1280, usual_height = 800;
/// Smallest and largest size that is taken for one; the farthest place.
inline constexpr int smallest_width = 640, smallest_height = 400, largest_size = 16384, farthest_place = 32767;

}  // namespace sightline
