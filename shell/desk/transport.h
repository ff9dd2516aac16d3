// Playing: a state machine that the window shows and whose buttons follow from its state.
//
//   ready    at step 0, standing      -> playing
//   playing  steps by the clock       -> paused (asked, or a breakpoint), finished (budget, empty front)
//   paused   in the run, standing     -> playing, ready (start)
//   finished at the end of the run    -> ready (start), paused (back)
//
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace sightline {

enum class TransportState : std::uint8_t { ready, playing, paused, finished };
inline constexpr auto transport_words = std::to_array<std::string_view>({"ready", "playing", "paused", "finished"});

struct Transport {
    bool playing = false;
    double steps_per_second = 2;
    double owed = 0;  ///< part of a step that the clock has already paid for
};

/// Limits of Transport::steps_per_second.
inline constexpr double slowest = 0.125, fastest = 65536;

}  // namespace sightline
