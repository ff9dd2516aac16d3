// Flying: the traversal follows the eye, frame by frame, without a recording until it lands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/session/pops.h"
#include "shell/desk/workbench.h"

namespace sightline {

/// Moves the culling view of both sessions and runs them to their budgets without a recording; while the view is frozen
/// the display view alone moves. `gesture` as remember() takes it.
template <int D>
void fly_to(Workbench<D>& bench, const ViewSpec<D>& view, const std::string& gesture);

/// Ends an unrecorded frame: the same frame is there to step through, at its end, with the rounds that completed it.
/// Does nothing when nothing flies.
template <int D>
void land(Workbench<D>& bench);

/// Scene units a second: what was chosen, or a tenth of the scene's longest side.
template <int D>
double flight_speed(const Workbench<D>& bench);

/// Where nobody flies any more, the frame is recorded: land().
template <int D>
void land_unless_moving(Workbench<D>& bench);

/// One of the scene, at its first frame. Throws InputError for a path that the scene does not have.
template <int D>
void choose_path(Workbench<D>& bench, const std::string& id);

/// Any other, moved into the scene; at its first frame.
template <int D>
void take_path(Workbench<D>& bench, FlightPath<D> path);

/// Shows a frame of the path (from 0), unrecorded. Throws InputError for a frame that it does not have.
template <int D>
void go_to_frame(Workbench<D>& bench, std::uint32_t frame);

/// Replays the path from where it stands, or from its beginning when it stands at its end. Throws InputError when there
/// is none.
template <int D>
void replay(Workbench<D>& bench);

/// Begins a new path at the culling view. Throws InputError while the view is frozen.
template <int D>
void record_path(Workbench<D>& bench);

/// Ends recording and replaying; the frame that is shown is recorded.
template <int D>
void stop_path(Workbench<D>& bench);

/// Marks of the pops (core/session/pops.h) between the frame of the path before and this one; none where the culling
/// view is not that of the path's frame, in its first frame, and in flight.
template <int D>
std::vector<Marker> frame_pops(const Workbench<D>& bench);

/// Replays the frame that is due, or records the place that the eye has reached. True when the view has moved.
template <int D>
bool advance_flight(Workbench<D>& bench, double seconds);

}  // namespace sightline
