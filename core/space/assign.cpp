// Which cells a segment crosses: from the cell of one end, across facets, while the closed cell meets the segment.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/space/builders.h"

namespace sightline {

namespace {

/// Whether the closed convex cell and the closed segment share a point. Two disjoint convex polygons are separated by
/// the line of an edge of one of them; the segment is a polygon with one edge. Exact.
bool meets(const CellComplex<2>& cells, std::uint32_t cell, const Primitive<2>& segment) {
    const auto& [a, b] = segment;
    const auto corners = cells.corners_of(cell);
    bool left = false, right = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec<2>& p = cells.points[corners[i]];
        const Vec<2>& q = cells.points[corners[i + 1 == corners.size() ? 0 : i + 1]];
        if (orient(p, q, a) < 0 && orient(p, q, b) < 0) return false;
        const int side = orient(a, b, p);
        left |= side >= 0;
        right |= side <= 0;
    }
    return left && right;
}

}  // namespace

void assign_primitives(CellComplex<2>& cells, const std::vector<Primitive<2>>& primitives, const Progress& progress) {
    std::vector<std::vector<CellPrimitive>> parts(1);
    std::vector<CellPrimitive>& pairs = parts[0];
    std::vector<std::uint32_t> reached_for(cells.cell_count(), none);  // last primitive that tried the cell
    std::vector<std::uint32_t> flood;
    cells.unassigned = 0;
    for (std::uint32_t primitive = 0; primitive < primitives.size(); ++primitive) {
        report_assigned(progress, primitive, primitives.size());
        const Primitive<2>& segment = primitives[primitive];
        flood.clear();
        const auto reach = [&](std::uint32_t cell) {
            if (reached_for[cell] == primitive) return;
            reached_for[cell] = primitive;
            if (meets(cells, cell, segment)) flood.push_back(cell);
        };
        for (const Vec<2>& end : segment)
            if (flood.empty())
                if (const std::uint32_t cell = locate(cells, end); cell != none) reach(cell);
        // Where a segment may enter when both its ends lie outside.
        if (flood.empty()) std::for_each(cells.border_cells.begin(), cells.border_cells.end(), reach);
        for (std::size_t i = 0; i < flood.size(); ++i) {
            pairs.push_back({flood[i], primitive});
            for (const HalfFacet& half : cells.facets_of(flood[i]))
                if (half.neighbour != none) reach(half.neighbour);
        }
        cells.unassigned += flood.empty();
    }
    set_cell_primitives<2>(cells, parts);
}

}  // namespace sightline
