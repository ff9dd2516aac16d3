// What a person flies with, and the path that is recorded or replayed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/scene/flight_path.h"

namespace sightline {

template <int D>
struct Flight {
    bool on = false;         ///< keys move the eye
    double speed = 0;        ///< scene units a second; 0: not yet chosen, a share of the scene's size
    bool completes = false;  ///< where the eye rests, the picture is completed (complete.h)
    bool completed = false;  ///< it is
    FlightPath<D> path{};    ///< being recorded or replayed; empty: none
    bool recording = false, replaying = false;
    bool loop = false;                 ///< replaying begins again where it ends
    bool bar = false;                  ///< the window shows what the path can do
    std::uint32_t frame = 0;           ///< of the path
    std::vector<ViewSpec<D>> ahead{};  ///< frames of the lane after the one that was stepped into
    double owed = 0;                   ///< part of a frame of the path that the clock has already paid for
};

/// How fast paths are recorded and, where the machine keeps up, replayed. No frame is left out.
inline constexpr double path_frames_per_second = 30;

}  // namespace sightline
