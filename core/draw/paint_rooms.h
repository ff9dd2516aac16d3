// The rooms of a scene, its portals, and what of the rooms a walk through them has seen.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/draw_list.h"
#include "core/session/session.h"

namespace sightline {

/// Whether what runs goes from room to room in a scene that has some.
template <int D>
bool walks_rooms(const Session<D>& session) {
    return session.traversal().rooms_seen().has_value();
}

/// Below the primitives: of each room what is seen through a window so far, as what is projected, and what waits, as
/// what is enqueued.
void paint_windows(const Session<2>& session, DrawList& list);
/// Above them: the portals.
void paint_portals(const Session<2>& session, DrawList& list);

/// 3D: per room what has become of it; clean: no window leads there so far.
std::vector<CellState> states_of_rooms(const Session<3>& session);

}  // namespace sightline
