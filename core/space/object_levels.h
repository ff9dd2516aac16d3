// Inside core/space: the levels of one object. Work on several objects may go on side by side.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/space/levels.h"

namespace sightline {

/// As Levels has them, of a few objects.
template <int D>
struct ObjectLevels {
    std::vector<Level> levels;
    std::vector<Primitive<D>> primitives;
    std::vector<std::uint8_t> two_sided;  ///< 3D
};

/// Appends the levels of the object with these primitives of the scene.
///
/// 2D: chains of segments that meet two at a time, thinned by Douglas and Peucker's rule; ends and crossings stay.
void append_levels(const Scene<2>& scene, std::span<const std::uint32_t> object, ObjectLevels<2>& out);
/// 3D: corners fall together that share a cell of a grid (Rossignac and Borrel 1993), at the one nearest their mean. A
/// triangle of which three corners are left is drawn with them; of those that collapse to a line or to a point where
/// none is drawn one stays as it was, so that nothing is lost however thin it is. One that turns over is shown from
/// both sides.
void append_levels(const Scene<3>& scene, std::span<const std::uint32_t> object, ObjectLevels<3>& out);

}  // namespace sightline
