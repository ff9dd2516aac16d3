// Interiors as a scene marks them: rooms, and the openings through which one is seen from another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/index.h"
#include "core/geometry/vec.h"

namespace sightline {

/// A convex part of an interior (DAS 3.1.2: "cell", which here is a cell of the tessellation). 2D: a convex polygon,
/// counter-clockwise; 3D: a box along the axes. Its border lets nothing through from inside but at its portals: that is
/// what the scene promises.
template <int D>
struct Room {
    std::string name;
    std::conditional_t<D == 2, std::vector<Vec<2>>, Box<3>> shape{};
    bool operator==(const Room&) const = default;
};

/// An opening between two rooms, or between a room and the outside. 2D: two points; 3D: a convex polygon in a plane.
template <int D>
struct Portal {
    std::array<std::uint32_t, 2> rooms{none, none};  ///< none: the outside; at most one of them is
    std::vector<Vec<D>> corners;
    bool operator==(const Portal&) const = default;
};

template <int D>
struct Rooms {
    std::vector<Room<D>> all;
    std::vector<Portal<D>> portals;
    /// How far from all rooms (in the coordinate that differs most) an eye outside must be for their border to let
    /// nothing in either, but at the portals: the thickness of walls that are closed from outside too. Infinite: from
    /// outside they are not. In 2D segments have no back, and it is 0.
    double closed_from = D == 2 ? 0 : std::numeric_limits<double>::infinity();
    bool empty() const { return all.empty(); }
    bool operator==(const Rooms&) const = default;
};

/// Whether the closed room holds the point. Exact.
bool holds(const Room<2>& room, const Vec<2>& p);
bool holds(const Room<3>& room, const Vec<3>& p);
/// The same of the room without its border.
bool holds_inside(const Room<2>& room, const Vec<2>& p);
bool holds_inside(const Room<3>& room, const Vec<3>& p);

/// Where an eye begins: in several rooms where it lies on what they share.
struct RoomsAt {
    std::vector<std::uint32_t> rooms;  ///< whose closure holds it, rising
    bool outside = false;              ///< it lies outside all of them, or on a border that may be that of the outside
};
template <int D>
RoomsAt rooms_at(const Rooms<D>& rooms, const Vec<D>& eye);

/// Whether walls are closed for an eye that lies outside all rooms: see Rooms::closed_from.
template <int D>
bool closed_for(const Rooms<D>& rooms, const Vec<D>& eye);

/// Some point inside it: of a convex polygon or box the middle, rounded.
Vec<2> middle_of(const Room<2>& room);
Vec<3> middle_of(const Room<3>& room);

/// Throws InputError, which begins with `name`, unless rooms are convex and have a size, and portals lie on the borders
/// of the rooms that they name. That walls are closed it does not see.
template <int D>
void check_rooms(const Rooms<D>& rooms, const std::string& name);

/// The portals between boxes that touch, where they touch: for free space that is cut into boxes.
std::vector<Portal<3>> portals_between(const std::vector<Room<3>>& rooms);

}  // namespace sightline
