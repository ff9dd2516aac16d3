// Flying: the traversal follows the eye, frame by frame, without a recording until it lands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/scene/flight_path.h"
#include "core/session/session.h"

namespace sightline {

template <int D>
struct Workbench;

/// What a person flies with.
template <int D>
struct Flight {
    bool on = false;       ///< keys move the eye
    double speed = 0;      ///< scene units a second; 0: not yet chosen, a share of the scene's size
    FlightPath<D> path{};  ///< being recorded or replayed; empty: none
    bool recording = false, replaying = false;
    std::uint32_t frame = 0;              ///< of the path
    double traverse_ms = 0, draw_ms = 0;  ///< of the last frame
};

/// Moves the culling view of both sessions and runs them to their budgets without a recording; while the view is frozen
/// the display view alone moves. `gesture` as remember() takes it.
template <int D>
void fly_to(Workbench<D>& bench, const ViewSpec<D>& view, const std::string& gesture);

/// Ends an unrecorded frame: the same frame is there to step through, at its end. Does nothing when nothing flies.
template <int D>
void land(Workbench<D>& bench);

/// Scene units a second: what was chosen, or a tenth of the scene's longest side.
template <int D>
double flight_speed(const Workbench<D>& bench);

/// Throws InputError for a path that the scene does not have.
template <int D>
void choose_path(Workbench<D>& bench, const std::string& id);

/// Shows a frame of the path (from 0). Throws InputError for a frame that it does not have.
template <int D>
void go_to_frame(Workbench<D>& bench, std::uint32_t frame);

}  // namespace sightline
