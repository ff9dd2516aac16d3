// The rooms of a scene, its portals, and what of the rooms a walk through them has seen, in a picture of 2D.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/draw_list.h"
#include "core/session/session.h"

namespace sightline {

/// Whether the method goes from room to room in a scene that has some.
bool walks_rooms(const Session<2>& session);

/// Below the primitives: of each room what is seen through a window so far, as what is projected, and what waits, as
/// what is enqueued.
void paint_windows(const Session<2>& session, DrawList& list);
/// Above them: the portals.
void paint_portals(const Session<2>& session, DrawList& list);

}  // namespace sightline
