// Inside core/scene: the floor plan of a wing of offices, which both dimensions build.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/scene/make/model.h"

namespace sightline {

inline constexpr double office_height = 2.8, office_door_height = 2.1;

// Walls run along the axes and their points are dyadic (model.h), so that neighbouring faces share their corners
// exactly.

/// A face of a wall from floor to ceiling, whose front is on the right of the way from a to b.
struct WallFace {
    Vec<2> a, b;
    std::vector<Opening> doors;
};

/// The way through a wall: where its two sides begin, and how far it goes and is wide.
struct DoorWay {
    Vec<2> left, right;  ///< of someone who goes in
    Vec<2> through;      ///< from one face of the wall to the other
};

/// A box on the floor: from `low` to `high` in the frame, and up to `top`; it has these sides (BoxSides).
struct FloorBox {
    Placement frame;
    Vec<2> low, high;
    double foot, top;
    unsigned sides;
};

/// Calls beside(p, q) for what is left and right of the doors, and above(p, q) for what is over them.
template <typename Beside, typename Above>
void for_pieces(const WallFace& face, Beside beside, Above above) {
    const Vec<2> whole = face.b - face.a, along = whole / std::sqrt(glm::dot(whole, whole));
    Vec<2> from = face.a;
    for (const Opening& door : face.doors) {
        const Vec<2> left = face.a + along * (door.at - door.width / 2);
        const Vec<2> right = face.a + along * (door.at + door.width / 2);
        beside(from, left);
        above(left, right);
        from = right;
    }
    beside(from, face.b);
}

/// A rectangle of free floor, by two opposite corners.
struct FreeFloor {
    const char* name;
    Vec<2> a, b;
    double top;
};

/// Walls are solid: what bounds them are the faces toward rooms and corridors and the sides of doorways.
struct OfficeWing {
    std::vector<WallFace> faces;
    std::vector<DoorWay> doorways;
    std::vector<FloorBox> boxes;
    std::vector<DoorWay> doors;   ///< those from a corridor into a room
    std::vector<FreeFloor> free;  ///< all that is not wall, from floor to ceiling but in doorways

    /// Convex polygons that its walls and boxes are in three dimensions, without floor and ceiling.
    std::size_t polygons() const;
};

/// A wing is 62 x 44 with its lower left corner at the origin: a ring of corridors and a cross of two, exits at the
/// ends of the cross.
inline constexpr Vec<2> wing_size{62, 44};
/// Middle lines of the corridors, which are 2 m wide; they cross one another in nine places.
inline constexpr double corridors_x[3] = {6.3125, 31, 55.6875}, corridors_y[3] = {6.3125, 22, 37.6875};

/// A wing of about so many polygons, to the nearest four where it is not full: with few, rooms are larger, and parts
/// are not built up.
OfficeWing office_wing(Random random, std::size_t polygons);

enum class WingSide { south, east, north, west };
/// The outer face of a wall that has no other wing behind it, with its half of the exit. Seen from outside it goes
/// round the corner at its left or right if no other wing stands there either.
OfficeWing outer_face(WingSide side, bool left_corner, bool right_corner);

}  // namespace sightline
