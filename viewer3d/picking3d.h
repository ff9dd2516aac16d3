// What of a 3D picture lies under the mouse: a ray against what is drawn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/draw/solid_list.h"

namespace sightline {

struct Pick3d {
    std::uint32_t primitive = 0xffffffffu;  ///< the nearest triangle that is drawn; none: 0xffffffff
    std::uint32_t cell = 0xffffffffu;       ///< the cell of the nearest face or edge that is drawn
    Vec<3> point{};                         ///< of the nearer of the two, where there is one
    bool hits() const { return primitive != 0xffffffffu || cell != 0xffffffffu; }
};

struct Ray3d {
    Vec<3> from, along;
};
/// From the eye through a point of the picture's plane.
Ray3d ray_through(const View<3>& view, const Vec<2>& plane);

/// Looks through a point of the picture's plane (projection.h). Takes time in proportion to the list.
Pick3d pick(const SolidList& list, const Vec<2>& plane);

}  // namespace sightline
