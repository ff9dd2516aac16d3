// Inside core/scene: furniture out of closed parts that stand on the floor of the model's frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/make/model.h"

namespace sightline {

/// Centred on the origin, looking toward -y; 0.45 wide.
void chair(Model& model);
/// Four legs and a top, centred on the origin, 0.75 high.
void table(Model& model, double width, double depth);
/// A table for four with its chairs, 1.5 x 2.4.
void dining_table(Model& model);
/// Open to -y, its back on y = 0, its foot from x = -width/2 to width/2; with books.
void shelf(Model& model, Random& random, double width, double height);
/// Its head on y = 0, reaching to y = -2.
void bed(Model& model, double width);
/// Its back on y = 0, looking toward -y; 2 wide.
void sofa(Model& model);
/// With a chair before it and a screen on it; its back on y = 0.
void desk(Model& model);

/// Something that suits the room, whose middle is the frame's origin; `width` along x, `depth` along y.
void furnish_room(Model& model, Random& random, double width, double depth);

/// About 5 m high; the foot is the frame's origin.
void garden_tree(Model& model, Random& random);
/// The arm reaches toward -y.
void street_lamp(Model& model);

}  // namespace sightline
