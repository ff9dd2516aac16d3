// A plan cut into triangles that keep to its lines: a constrained triangulation with exact decisions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/geometry/vec.h"

namespace sightline {

/// Triangles of a set of points, which are corners of them all; half-edge 3t + k goes from corner k of triangle t to
/// the next, counter-clockwise.
struct PlanMesh {
    std::vector<Vec<2>> points;
    std::vector<std::uint32_t> from;  ///< per half-edge: the point that it leaves
    std::vector<std::uint32_t> twin;  ///< the same edge from the other side; none: at the border
    std::vector<std::uint8_t> kept;   ///< per half-edge: bits of the lines that cover all of it
    std::uint32_t left_out = 0;       ///< lines, or parts of them, that cross others between points

    static std::uint32_t next(std::uint32_t half) { return half % 3 == 2 ? half - 2 : half + 1; }
    std::uint32_t to(std::uint32_t half) const { return from[next(half)]; }
    std::size_t triangles() const { return from.size() / 3; }
};

/// A line of a plan and its bit.
struct PlanLine {
    std::array<Vec<2>, 2> ends;
    std::uint8_t bit = 1;
};

/// Its points are the ends of the lines, and a line is made of edges: a bit stands on an edge only if its lines cover
/// it to the last point, in real arithmetic. A line that another one crosses where neither ends is left out from there
/// to its next point. Without three points that are not in line there are no triangles.
PlanMesh triangulate_plan(std::span<const PlanLine> lines);

}  // namespace sightline
