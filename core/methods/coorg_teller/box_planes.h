// The supporting and separating planes of an occluder and a box, as people see them: each touches both.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/coorg_teller/box_states.h"
#include "core/run/explanation.h"

namespace sightline {

/// First the occluder's own planes, then of each silhouette edge the supporting and the separating one (CT figure 4a).
/// Their corner of the box is the one at which a plane through the edge touches it: with occluder and box on one side,
/// or on both. An edge whose line meets the box has none: its planes are left out where they are satisfied, else they
/// go through the corner that lies farthest on the wrong side.
template <int D>
std::vector<TestedPlane<D>> box_planes(const Shadow<D>& shadow, const Polygons<D>& polygons, const Scene<D>& scene,
                                       const Box<D>& box, const Vec<D>& eye);

/// The silhouette of occluders that hide a box together, as slots: the edges that they share are none of its sides.
/// With fused shadows (2D) it has two sides, the right end of the first one and the left end of the last.
template <int D>
Shadow<D> joint_shadow(const BoxStates<D>& states, const Polygons<D>& polygons, const Scene<D>& scene,
                       std::span<const std::uint32_t> slots, const Vec<D>& eye);

/// Of `slots` the occluder that comes nearest to hiding the box: of those that hide a part of it the one with the
/// fewest supporting planes that are not satisfied, of these the largest; where none hides a part, the one with the
/// fewest separating planes that are not. none: there is no slot.
template <int D>
std::uint32_t best_occluder(const BoxStates<D>& states, std::uint32_t node, std::span<const std::uint32_t> slots);

}  // namespace sightline
