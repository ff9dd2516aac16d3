// The exact visible set in 2D: envelopes about the eye, merged with exact predicates.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace sightline {

/// A maximal stretch of one primitive that the eye sees, counter-clockwise about the eye, clipped to the view cone.
/// Which primitive is seen is exact; the end points are rounded, to within 1e-14 of the primitive's largest coordinate.
struct VisiblePiece {
    std::uint32_t primitive = none;
    Vec<2> from{}, to{};
};

/// Rules: a primitive is visible when an open interval of directions inside the cone of positive measure meets it
/// first. Where several overlap (duplicates, collinear overlaps) the lowest id is the one seen. A primitive on a line
/// through the eye subtends no angle: it is never seen and hides nothing.
struct VisibleSet {
    std::vector<std::uint8_t> visible;  ///< 1 per visible primitive, indexed by primitive
    std::vector<VisiblePiece> pieces;   ///< in counter-clockwise order, starting at the right border of the cone (or
                                        ///< at direction +x for an all-round view)
    std::size_t count = 0;              ///< |V|
    std::size_t eye_on = 0;             ///< primitives that contain the eye; reported, see the rules
};

/// O(n a(n) log n) whatever the number of crossings (a: inverse Ackermann).
VisibleSet exact_visible_set(std::span<const Primitive<2>> primitives, const View<2>& view);

/// Layering number of every primitive (TVCG section 3): its smallest rank among the primitives along the rays inside
/// the cone that hit it, 1 = visible; 0 when no ray hits it. Exact; overlapping primitives are ranked by id.
/// Time and memory also grow with the number of crossings, and time with the number of primitives along a ray.
std::vector<std::uint32_t> layering_numbers(std::span<const Primitive<2>> primitives, const View<2>& view);

}  // namespace sightline
