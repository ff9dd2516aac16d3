// Rooms of a plan, found from its walls.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/scene/scene.h"

namespace sightline {

/// The free space between the walls, cut into convex rooms whose corners are ends of walls; what is left open between
/// two rooms is a portal, and so is each cut. `openings` are lines where the rooms end though no wall stands there,
/// such as doors to the outside; they may lie over walls. What can be reached from far outside without crossing a wall
/// or an opening belongs to no room. Exact: a border counts as a wall only where walls cover it to the last point, so
/// that walls that do not quite meet leave a portal.
Rooms<2> plan_rooms(std::span<const Primitive<2>> walls, std::span<const Primitive<2>> openings = {});

/// The rooms of `after`, which is `before` with walls changed: the same ones while all that closes them stands, else
/// those between the walls that are left; portals stay where they can.
Rooms<2> rooms_after_edit(const Scene<2>& before, const Scene<2>& after);

}  // namespace sightline
