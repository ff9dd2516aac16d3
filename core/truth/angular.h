// What the 2D measures share: segments as arcs of directions about the eye, exact comparison of directions, and which
// of two segments is the nearer one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/geometry/crossing.h"
#include "core/geometry/predicates.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace sightline {

/// A primitive that subtends an angle: the path eye, right, left turns counter-clockwise.
struct Facing {
    Vec<2> right, left;
    std::uint32_t primitive;
};

/// The primitives that subtend an angle, in order of their ids, and how many contain the eye.
struct FacingSet {
    std::vector<Facing> facing;
    std::size_t eye_on = 0;
};
FacingSet facing_set(std::span<const Primitive<2>> primitives, const Vec<2>& eye);

/// A closed range of directions of at most 180 degrees, so that one orientation test orders the directions in it.
struct Sector {
    Vec<2> eye, right, left;
    bool half_plane = false;
};

/// The view in counter-clockwise order: its cone, or the upper and the lower half plane.
std::vector<Sector> sectors(const View<2>& view);

/// A direction from the eye: towards `point`, or when `second` is set towards the crossing of two facing segments.
struct Direction {
    Vec<2> point{};
    std::uint32_t first = none, second = none;
    bool is_crossing() const { return second != none; }
};

/// The directions in a sector in which a facing segment is hit; `from` < `to`.
struct Arc {
    Direction from, to;
    std::uint32_t facing = none;
};

/// The part of every facing segment inside the sector, in the same order; no empty arcs.
std::vector<Arc> clipped_arcs(std::span<const Facing> facing, const Sector& sector);

int turn_between_crossings(const Vec<2>& eye, std::span<const Facing> facing, const Direction& d, const Direction& e);

/// For two directions of one sector: +1 when e is counter-clockwise of d, 0 when they are equal, -1 otherwise.
inline int turn(const Vec<2>& eye, std::span<const Facing> facing, const Direction& d, const Direction& e) {
    if (d.is_crossing() || e.is_crossing()) return turn_between_crossings(eye, facing, d, e);
    return orient(eye, d.point, e.point);
}

/// Which of two facing segments is the nearer one in directions that hit both.
enum class Nearer { first, second, first_until_crossing, second_until_crossing };

/// Exact; `a` has the lower id and is the nearer one where both overlap.
inline Nearer nearer(const Facing& a, const Facing& b) {
    // The eye lies to the left of each, and what is on the eye's side of a line is hit before that line is.
    const int b_right = orient(a.right, a.left, b.right), b_left = orient(a.right, a.left, b.left);
    if (b_right <= 0 && b_left <= 0) return Nearer::first;
    if (b_right >= 0 && b_left >= 0) return Nearer::second;
    const int a_right = orient(b.right, b.left, a.right), a_left = orient(b.right, b.left, a.left);
    if (a_right >= 0 && a_left >= 0) return Nearer::first;
    if (a_right <= 0 && a_left <= 0) return Nearer::second;
    return b_right > 0 ? Nearer::second_until_crossing : Nearer::first_until_crossing;
}

/// Where a facing segment is hit in a direction that hits it, rounded as in crossing.h.
Vec<2> point_on(std::span<const Facing> facing, std::uint32_t index, const Vec<2>& eye, const Direction& direction);

}  // namespace sightline
