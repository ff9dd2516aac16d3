// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/cut_polygon.h"

#include <cmath>
#include <utility>

#include "core/base/index.h"
#include "core/geometry/predicates.h"
#include "core/scene/clean.h"

namespace sightline {

namespace {

/// Including the border; counter-clockwise.
bool is_in_triangle(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& p) {
    if (p.x < std::min({a.x, b.x, c.x}) || p.x > std::max({a.x, b.x, c.x})) return false;
    if (p.y < std::min({a.y, b.y, c.y}) || p.y > std::max({a.y, b.y, c.y})) return false;
    return orient(a, b, p) >= 0 && orient(b, c, p) >= 0 && orient(c, a, p) >= 0;
}

}  // namespace

/// Looks along the axis on which the polygon is largest, from its front; false where it has no area or no usable
/// coordinates.
bool PolygonCutter::flatten(std::span<const Vec<3>> corners) {
    Vec<3> normal(0);  // Newell's, from the first corner, so that far polygons keep their digits
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(corners[i][axis]) <= largest_triangle_coordinate)) return false;
        if (i > 1) normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    int along = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(normal[axis]) > std::abs(normal[along])) along = axis;
    if (normal[along] == 0) return false;
    int u = (along + 1) % 3, v = (along + 2) % 3;
    if (normal[along] < 0) std::swap(u, v);
    flat_.resize(corners.size());
    const auto count = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i < count; ++i)
        flat_[i] = {{corners[i][u], corners[i][v]}, (i + count - 1) % count, (i + 1) % count, none, false};
    return true;
}

int PolygonCutter::turn(std::size_t corner) const {
    const Corner& c = flat_[corner];
    return orient(flat_[c.before].at, c.at, flat_[c.after].at);
}

/// Turns left everywhere and goes round once.
bool PolygonCutter::is_convex() const {
    int reversals = 0;
    for (std::size_t i = 0; i < flat_.size(); ++i) {
        if (turn(i) <= 0) return false;
        const Corner& c = flat_[i];
        // Rightmost and leftmost corners; of an edge that stands upright, its later end.
        const double in = c.at.x - flat_[c.before].at.x, out = flat_[c.after].at.x - c.at.x;
        const double far_out = out != 0 ? out : flat_[flat_[c.after].after].at.x - flat_[c.after].at.x;
        if (in != 0) reversals += (in > 0) != (far_out > 0);
    }
    return reversals <= 2;
}

bool PolygonCutter::is_ear(std::uint32_t corner) {
    const Corner& c = flat_[corner];
    if (c.bent) return false;
    const Vec<2>&a = flat_[c.before].at, &b = c.at, &d = flat_[c.after].at;
    const auto spoils = [&](std::uint32_t other) {
        const Vec<2>& p = flat_[other].at;
        return flat_[other].bent && is_in_triangle(a, b, d, p) && p != a && p != b && p != d;
    };
    const auto may_test = [&] { return tests_left_ > 0 && tests_left_-- > 0; };
    const Cell from = cell(glm::min(a, glm::min(b, d))), to = cell(glm::max(a, glm::max(b, d)));
    if (std::size_t{to.x - from.x + 1} * (to.y - from.y + 1) < bent_count_) {
        for (std::uint32_t y = from.y; y <= to.y; ++y)
            for (std::uint32_t x = from.x; x <= to.x; ++x) {
                if (!may_test()) return false;
                for (std::uint32_t i = grid_[y * grid_side_ + x]; i != none; i = flat_[i].next_in_cell)
                    if (!may_test() || spoils(i)) return false;
            }
        return true;
    }
    for (std::size_t i = 0; i < bent_.size();) {
        if (!may_test()) return false;
        if (flat_[bent_[i]].bent) {
            if (spoils(bent_[i++])) return false;
        } else {  // cut off, or convex by now
            bent_[i] = bent_.back();
            bent_.pop_back();
        }
    }
    return true;
}

void PolygonCutter::make_grid() {
    box_ = {};
    for (const Corner& corner : flat_) box_.add(corner.at);
    grid_side_ = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(flat_.size())));
    grid_.assign(std::size_t{grid_side_} * grid_side_, none);
    bent_.clear();
    bent_count_ = 0;
    for (std::uint32_t i = 0; i < flat_.size(); ++i) {
        Corner& corner = flat_[i];
        const Cell at = cell(corner.at);
        corner.next_in_cell = std::exchange(grid_[at.y * grid_side_ + at.x], i);
        bend(i);
    }
}

PolygonCutter::Cell PolygonCutter::cell(const Vec<2>& at) const {
    const auto along = [&](int axis) {
        const double share = (at[axis] - box_.min[axis]) / (box_.max[axis] - box_.min[axis]);
        return static_cast<std::uint32_t>(share * (grid_side_ - 1));
    };
    return {along(0), along(1)};
}

/// Says anew whether the corner is.
void PolygonCutter::bend(std::uint32_t corner) {
    const bool was = flat_[corner].bent;
    flat_[corner].bent = turn(corner) <= 0;
    if (flat_[corner].bent && !was) bent_.push_back(corner), ++bent_count_;
    if (!flat_[corner].bent && was) --bent_count_;
}

bool PolygonCutter::clip(std::span<const Vec<3>> corners, std::vector<Primitive<3>>& triangles) {
    make_grid();
    std::uint32_t at = 0;
    std::size_t left = corners.size(), refused = 0;
    while (left > 3) {
        if (tests_left_ == 0) return false;
        const std::uint32_t before = flat_[at].before, after = flat_[at].after;
        const bool stuck = refused >= left;
        if (!stuck && !is_ear(at)) {
            at = after;
            ++refused;
            continue;
        }
        triangles.push_back({corners[before], corners[at], corners[after]});
        bent_count_ -= flat_[at].bent;
        flat_[at].bent = false;
        flat_[before].after = after;
        flat_[after].before = before;
        bend(before);
        bend(after);
        at = after;
        --left;
        refused = 0;
    }
    triangles.push_back({corners[flat_[at].before], corners[at], corners[flat_[at].after]});
    return true;
}

bool PolygonCutter::cut(std::span<const Vec<3>> corners, std::vector<Primitive<3>>& triangles) {
    const std::size_t count = corners.size();
    if (count == 3) triangles.push_back({corners[0], corners[1], corners[2]});
    if (count <= 3) return true;
    std::size_t tip = count == 4 ? 0 : count - 1;
    if (flatten(corners)) {
        if (count > 4 && !is_convex()) return clip(corners, triangles);
        for (std::size_t i = 0; i < count && count == 4; ++i)
            if (turn(i) <= 0) tip = turn(tip) < 0 ? tip : i;
    }
    for (std::size_t i = 1; i + 1 < count; ++i)
        triangles.push_back({corners[tip], corners[(tip + i) % count], corners[(tip + i + 1) % count]});
    return true;
}

}  // namespace sightline
