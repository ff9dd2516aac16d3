// What of a 3D picture lies under the mouse: a ray against what is drawn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "core/draw/solid_list.h"
#include "core/space/cell_complex.h"

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

/// The cell of several that the ray enters, or leaves, first; none: it meets none of them.
std::uint32_t cell_along(const CellComplex<3>& cells, std::span<const std::uint32_t> among, const Ray3d& ray);

}  // namespace sightline
