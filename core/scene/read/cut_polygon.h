// Polygons cut into triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace sightline {

/// Cuts the polygons of one file. Of n corners come n - 2 triangles that turn as the polygon does:
///  - four corners: from the one that is not convex, else from the first;
///  - more, convex: a fan about the last corner;
///  - else, seen along its main axis: corners are cut off one by one, in their order, where no other corner lies in
///  what
///    is cut off (ear clipping). Where a polygon crosses itself so that there is none, the next corner is cut off.
class PolygonCutter {
public:
    /// Ear clipping may take the square of the corners: all polygons together get time in proportion to the file.
    explicit PolygonCutter(std::uint64_t file_bytes) : tests_left_(150'000'000 + 10 * file_bytes) {}

    /// Appends the triangles; false: that would take too long. Fewer than three corners give none.
    bool cut(std::span<const Vec<3>> corners, std::vector<Primitive<3>>& triangles);

private:
    struct Corner {
        Vec<2> at;
        std::uint32_t before, after;
        std::uint32_t next_in_cell;
        bool bent;  ///< not convex: what may lie in an ear
    };
    /// Of a grid over the polygon.
    struct Cell {
        std::uint32_t x, y;
    };

    bool flatten(std::span<const Vec<3>> corners);
    int turn(std::size_t corner) const;
    bool is_convex() const;
    bool is_ear(std::uint32_t corner);
    void make_grid();
    Cell cell(const Vec<2>& at) const;
    void bend(std::uint32_t corner);
    bool clip(std::span<const Vec<3>> corners, std::vector<Primitive<3>>& triangles);

    std::uint64_t tests_left_;
    std::vector<Corner> flat_;
    std::vector<std::uint32_t> bent_;  ///< all that are bent, and others
    std::size_t bent_count_ = 0;
    std::vector<std::uint32_t> grid_;  ///< per cell its first corner; those that are bent are there
    std::uint32_t grid_side_ = 0;
    Box<2> box_;
};

}  // namespace sightline
