// How much a polygon promises to hide, and from where it promises enough.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/vec.h"

namespace sightline {

/// A · D / |D|³, the area-angle of CT section 3.3 and figure 8a: about the solid angle in steradians; 2D: about the
/// angle in radians. `area`: as Polygons::area. Positive where the eye is on the side of the front; 0 at the centre.
template <int D>
double area_angle(const Vec<D>& area, const Vec<D>& centre, const Vec<D>& eye);

/// A box round all eyes from which the area-angle is at least `threshold` (figure 8b, 8c): 3D, a lobe of the reach
/// √(|A| / threshold) √cosθ in front of the polygon; 2D, a circle with the diameter length / threshold. Two of them
/// where both sides count. Tight but for rounding.
template <int D>
Box<D> occluder_region(const Vec<D>& area, const Vec<D>& centre, double threshold, bool both_sides);

/// The outline of that region, for pictures: 2D, `count` points round it; 3D, of its section through the normal and
/// `across`, which need not be orthogonal to it. One lobe: the one of the front.
template <int D>
std::vector<Vec<D>> region_outline(const Vec<D>& area, const Vec<D>& centre, double threshold, const Vec<D>& across,
                                   int count);

}  // namespace sightline
