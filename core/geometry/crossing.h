// Where two segments cross, without rounding: a crossing is kept as its two segments; predicates see the real point.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/geometry/vec.h"

namespace sightline {

using Segment = std::array<Vec<2>, 2>;

/// The point where two segments cross properly: each has its ends strictly on opposite sides of the other's line.
struct Crossing {
    Segment s, t;
};

/// As orient(eye, p, q) of predicates.h, exact, for points of which one or both are crossings.
int orient(const Vec<2>& eye, const Crossing& p, const Vec<2>& q);
int orient(const Vec<2>& eye, const Crossing& p, const Crossing& q);

/// The crossing, rounded to within 1e-14 of the largest coordinate of `p.s`, and inside its bounding box.
Vec<2> rounded(const Crossing& p);

/// Where the line through the eye and `p` meets segment `s`, whose ends must lie on different closed sides of that line
/// and not both on it. Rounded as above.
Vec<2> hit(const Segment& s, const Vec<2>& eye, const Vec<2>& p);
Vec<2> hit(const Segment& s, const Vec<2>& eye, const Crossing& p);

}  // namespace sightline
