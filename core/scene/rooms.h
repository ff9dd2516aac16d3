// Interiors as a scene marks them: rooms, and the openings through which one is seen from another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
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
    bool empty() const { return all.empty(); }
    bool operator==(const Rooms&) const = default;
};

}  // namespace sightline
