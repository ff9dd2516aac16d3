// Inside core/scene: walls with openings, and houses made of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/make/model.h"

namespace sightline {

/// A window or a door in a wall, in the wall's own x and z.
struct WallOpening {
    double x0, x1, z0, z1;
};

/// A wall along x: its outer face on y = 0 looks toward -y, its inner face is on y = thick.
struct WallPanel {
    double x0, x1, z0, z1;  ///< the outer face
    double thick = 0.25;
    /// What the inner face leaves out at both ends and below, where other walls and the floor meet it.
    double inner_ends = 0, inner_foot = 0;
};

/// Both faces and the cheeks of the openings, which stand in order of x and do not overlap. An opening that begins at
/// the foot of the wall has no sill.
void wall_panel(Model& model, const WallPanel& wall, std::span<const WallOpening> openings);

/// A house with its front on y = 0, from x = 0 to width, back to y = depth.
struct House {
    double width, depth;
    int storeys;
    bool flat_roof;
};
inline constexpr double storey_height = 2.8;

/// Walls, floors and roof: closed but for doors and windows.
void house_shell(Model& model, Random& random, const House& house);

/// Inner walls with doors, and furniture. Stops when the model is full.
void house_rooms(Model& model, Random& random, const House& house);

}  // namespace sightline
