// Inside core/scene: buildings whose rooms are marked, with the openings through which one is seen from another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/make/model.h"

namespace sightline {

/// A model whose parts have names, and its marked rooms.
struct NamedModel {
    Model model;
    Objects objects;
    Rooms<3> rooms;

    /// What build(model) adds is an object of this name. Nothing once the model is full.
    template <typename Build>
    void add(std::string name, Build build) {
        if (model.full()) return;
        build(model);
        if (model.triangles.size() == objects.of.size()) return;
        objects.names.push_back(std::move(name));
        objects.of.resize(model.triangles.size(), static_cast<std::uint32_t>(objects.names.size() - 1));
    }
};

/// Numbers things of a kind: "building 3 / desk 1", "building 3 / desk 2", …
struct NumberedNames {
    std::string place;  ///< "building 3 / ", or empty
    std::map<std::string, int> count{};
    std::string next(const std::string& kind) { return place + kind + " " + std::to_string(++count[kind]); }
};

enum class PlannedUse { corridor, office, seminar, laboratory, hall, kiosk };

/// A room of every storey. Inner walls have no thickness: each is a face toward either side, so that rooms meet.
struct PlannedRoom {
    RoomPlan floor;
    PlannedUse use;
    double door = 0;   ///< x of the middle of the door to the corridor, from which the room is furnished
    bool back = true;  ///< the corridor is in front of it, at smaller y
};

/// An exit is one on the ground and a window above.
enum class PlannedGap { door, exit, window };

/// In a wall along x or y, from p to q, in the plane of the rooms' walls.
struct PlannedOpening {
    std::uint32_t from, to;  ///< rooms; none: the outside
    Vec<2> p, q;
    PlannedGap gap;
};

/// What each storey is: rooms that fill a rectangle from the origin on, and openings between them. All is dyadic.
struct BuildingPlan {
    double length, depth;
    int storeys;
    std::vector<PlannedRoom> rooms;
    std::vector<PlannedOpening> openings;
};

inline constexpr double campus_storey = 3, campus_door = 2.125, campus_step = 0.125, campus_facade = 0.25;

/// Two rows of `rooms` rooms along a corridor with an exit at either end.
BuildingPlan offices_plan(Random& random, double length, int rooms, int storeys);
/// One room with two exits.
BuildingPlan hall_plan(double length, double depth, PlannedUse use);

/// Walls, floors, ceilings and roof: closed but for openings, and without cracks, since faces that meet share all
/// corners along their edge. Marks the rooms. The ground is at z = 0 of the model's frame, which is turned by a
/// multiple of 90 degrees.
void campus_shell(NamedModel& made, const BuildingPlan& plan, NumberedNames& names);

/// The same at the height of an eye on the ground, where windows are open: inner walls once, the faces of the facade,
/// and the sides of the openings in it. Marks the rooms.
void campus_walls(Sketch& sketch, Rooms<2>& rooms, const BuildingPlan& plan, const std::string& place);

}  // namespace sightline
