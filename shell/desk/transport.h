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

template <int D>
struct Workbench;

enum class TransportState : std::uint8_t { ready, playing, paused, finished };
inline constexpr auto transport_words = std::to_array<std::string_view>({"ready", "playing", "paused", "finished"});

struct Transport {
    bool playing = false;
    double steps_per_second = 2;
    double owed = 0;  ///< part of a step that the clock has already paid for
};

/// Limits of Transport::steps_per_second.
inline constexpr double slowest = 0.125, fastest = 65536;

template <int D>
TransportState transport_state(const Workbench<D>& bench);

/// Starts to play; from the start again where the run is finished.
template <int D>
void play(Workbench<D>& bench);
template <int D>
void pause(Workbench<D>& bench);

/// Sets the speed so that the whole run takes this long.
template <int D>
void play_whole_run_in(Workbench<D>& bench, double seconds);

/// Makes the steps that are due after this much time. Stops at breakpoints, at the budget and at the empty front.
template <int D>
void advance_clock(Workbench<D>& bench, double seconds);

}  // namespace sightline
