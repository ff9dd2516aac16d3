// What upload and drawing will cost a frame, predicted from the frames before, so that a budget in time holds for all.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sightline {

/// What follows a traversal: upload and drawing, as a line over the number of rendered primitives. Nothing follows one
/// that is not drawn.
struct FrameCost {
    double per_primitive_ms = 0, fixed_ms = 0;

    bool operator==(const FrameCost&) const = default;
    double ms(std::uint32_t rendered) const { return fixed_ms + per_primitive_ms * rendered; }
};

/// The milliseconds that may still go into a traversal which has taken `elapsed_ms` and rendered so many primitives;
/// never negative.
double traversal_ms_left(double budget_ms, double elapsed_ms, const FrameCost& cost, std::uint32_t rendered);

/// What the last frames were drawn for.
struct DrawnFrames {
    struct Frame {
        std::uint32_t rendered = 0;
        double ms = 0;  ///< upload and drawing
        bool operator==(const Frame&) const = default;
    };
    std::array<Frame, 16> last{};  ///< a ring: frame i is last[i % 16]
    std::size_t count = 0;         ///< of all frames
};

/// A time that is negative or no number is not noted.
void note_frame(DrawnFrames& frames, std::uint32_t rendered, double ms);

/// The line above which none of the last frames lies, so that 19 of 20 stay within a budget; one that lies a quarter of
/// the budget above all others was interrupted, and does not count. The slope is the median of those between two
/// frames. Before the first frame a guess on the safe side, for a slow software rasteriser: 1 µs a primitive and a
/// quarter of the budget. A function of its arguments alone; never negative.
FrameCost predict_cost(const DrawnFrames& frames, double budget_ms);

}  // namespace sightline
