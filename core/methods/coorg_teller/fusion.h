// Whether occluders of any kind hide a box together in 2D: their shadows' angles, one after the other, cover its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/coorg_teller/joint_test.h"

namespace sightline {

/// The answer to CT figure 3c in the plane: the occluders of a set that hides the box, as indices into `partial`, from
/// its right end to its left; empty: there is none among those that the box lies beyond, or the eye is in the box.
/// `corners`: of the box, or of whatever convex shape. Exact. Lowers `slack` to what the eye can move before a turn
/// that was asked can be another.
std::vector<std::uint32_t> fused_set(std::span<const Shadow<2>> shadows, std::span<const Partial> partial,
                                     std::span<const Vec<2>> corners, const Vec<2>& eye, double& slack);

}  // namespace sightline
