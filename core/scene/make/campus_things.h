// Inside core/scene: what stands in and round the buildings of a campus, thing by thing, each an object.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/make/campus_building.h"

namespace sightline {

/// Furniture of one room; the frame is that of the building, its floor at z = 0. A way straight through the door stays
/// free: 0.6 to either side of it, and so is the part of the room near the door. Stops when the model is full.
void furnish_planned(NamedModel& made, NumberedNames& names, Random random, const PlannedRoom& room);

/// 4.3 long and 1.7 wide, about the frame's origin, its front toward -x. The inside is empty and cannot be seen.
void simple_car(Model& model);
/// About the frame's origin, 1.8 long in x.
void bench(Model& model);
/// A round post, 0.9 high.
void bollard(Model& model);

}  // namespace sightline
