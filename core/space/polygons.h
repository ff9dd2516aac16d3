// Convex polygons that the primitives of a scene form, and which of them share an edge.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/scene/scene.h"

namespace sightline {

/// Corners at the same place are one point; triangles of one side that lie in one plane and meet at an edge are one
/// polygon where that is convex (Coorg and Teller 1996, section 2). 2D: polygons are the segments, and what they share
/// are end points. Flat arrays; row i of X is X[X_begin[i], X_begin[i + 1]).
///
/// Triangles count as in one plane when rounding their corners to floats may have parted them. What is decided with a
/// polygon must therefore ask all of its planes, and then needs no tolerance.
template <int D>
struct Polygons {
    /// An edge of a polygon (3D: from corner `point` to the next one's), or an end of a segment.
    struct Side {
        std::uint32_t point = none;
        std::uint32_t edge = none;  ///< the same number for all polygons that share it
        bool reversed = false;      ///< 3D: this side runs against the direction of the edge
    };

    std::vector<Vec<D>> points;
    std::vector<std::uint32_t> side_begin{0};
    std::vector<Side> sides;  ///< 3D: counter-clockwise round the polygon as seen from its front; 2D: start and end
    std::vector<std::uint32_t> member_begin{0};
    std::vector<std::uint32_t> members;     ///< primitives, ascending in a polygon
    std::vector<std::uint32_t> polygon_of;  ///< of each primitive
    /// Primitives whose planes differ, of each polygon; mostly one.
    std::vector<std::uint32_t> plane_begin{0};
    std::vector<std::uint32_t> planes;
    /// Length: area (2D: length); direction: of its front (2D: to the left of the way from start to end).
    std::vector<Vec<D>> area;
    std::vector<Vec<D>> centre;  ///< the mean of the corners
    std::vector<std::uint8_t> two_sided;
    std::uint32_t edge_count = 0;

    std::uint32_t size() const { return static_cast<std::uint32_t>(centre.size()); }
    std::span<const Side> sides_of(std::uint32_t polygon) const { return row(sides, side_begin, polygon); }
    std::span<const std::uint32_t> members_of(std::uint32_t polygon) const {
        return row(members, member_begin, polygon);
    }
    std::span<const std::uint32_t> planes_of(std::uint32_t polygon) const { return row(planes, plane_begin, polygon); }
    /// The corners, in the order of the sides.
    std::vector<Vec<D>> corners_of(std::uint32_t polygon) const {
        std::vector<Vec<D>> corners;
        for (const Side& side : sides_of(polygon)) corners.push_back(points[side.point]);
        return corners;
    }

private:
    template <typename T>
    static std::span<const T> row(const std::vector<T>& rows, const std::vector<std::uint32_t>& begin,
                                  std::uint32_t i) {
        return std::span(rows).subspan(begin[i], begin[i + 1] - begin[i]);
    }
};

/// Polygons are numbered by their lowest primitive. Cost: n log n.
Polygons<2> build_polygons(const Scene<2>& scene);
Polygons<3> build_polygons(const Scene<3>& scene);

}  // namespace sightline
