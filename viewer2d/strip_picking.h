// What of the strip of what the eye sees lies under the mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/draw/eye_strip.h"

namespace sightline {

struct StripPick {
    int pixel = 0;
    bool drawn_band = false;  ///< else the exact band, or the marks under it
    EyeStrip::Piece piece;    ///< that holds the pixel

    /// The segment that this band shows there; none: nothing.
    std::uint32_t primitive() const { return drawn_band ? piece.drawn : piece.exact; }
};

/// Nothing beside the bands. On a mark it is one of the pixels that the mark is about.
std::optional<StripPick> pick_strip(const EyeStrip& strip, const EyeStripPlace& place, const Vec<2>& at);

/// The line of sight through the middle of the pixel, from the eye to the segment that the band shows there; where it
/// shows nothing, `far` long.
std::array<Vec<2>, 2> line_of_sight(const Session<2>& session, const EyeStrip& strip, const StripPick& pick,
                                    double far);

/// For a tooltip: "pixel 412: segment 17, missing: segment 30 is drawn instead". Pixels count from 1, from the left.
std::string strip_words(const Scene<2>& scene, const EyeStrip& strip, const StripPick& pick);

}  // namespace sightline
