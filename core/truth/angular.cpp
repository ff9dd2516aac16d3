// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/angular.h"

#include <limits>

namespace sightline {

namespace {

/// The point at the given distance in direction +x or -x; a finite one whatever the eye is.
Vec<2> beside(const Vec<2>& eye, double dx) {
    constexpr double largest = std::numeric_limits<double>::max();
    return {std::clamp(eye.x + dx, -largest, largest), eye.y};
}

/// Whether the direction of p lies strictly between the borders.
bool inside(const Sector& sector, const Vec<2>& p) {
    return orient(sector.eye, sector.right, p) > 0 && (sector.half_plane || orient(sector.eye, p, sector.left) > 0);
}

/// Whether p lies on the ray from the eye through `border`.
bool on_border(const Vec<2>& eye, const Vec<2>& border, const Vec<2>& p) {
    const auto sign = [](double value) { return (value > 0) - (value < 0); };
    return orient(eye, border, p) == 0 && sign(p.x - eye.x) == sign(border.x - eye.x) &&
           sign(p.y - eye.y) == sign(border.y - eye.y);
}

Crossing crossing_of(std::span<const Facing> facing, const Direction& d) {
    const Facing &s = facing[d.first], &t = facing[d.second];
    return {{s.right, s.left}, {t.right, t.left}};
}

}  // namespace

FacingSet facing_set(std::span<const Primitive<2>> primitives, const Vec<2>& eye) {
    FacingSet set;
    set.facing.reserve(primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const auto& [a, b] = primitives[i];
        const int side = orient(eye, a, b);
        if (side > 0) set.facing.push_back({a, b, static_cast<std::uint32_t>(i)});
        if (side < 0) set.facing.push_back({b, a, static_cast<std::uint32_t>(i)});
        if (side == 0 && a != b && segments_meet(a, b, eye, eye)) ++set.eye_on;
    }
    return set;
}

std::vector<Sector> sectors(const View<2>& view) {
    if (!view.all_round) return {{view.eye, view.corners[0], view.corners[1], false}};
    // A distance that scales with the eye keeps results equal under scaling by powers of two; no decision depends on
    // it.
    const double distance = view.eye.x == 0 ? 1 : std::abs(view.eye.x);
    const Vec<2> ahead = beside(view.eye, distance), behind = beside(view.eye, -distance);
    return {{view.eye, ahead, behind, true}, {view.eye, behind, ahead, true}};
}

std::vector<Arc> clipped_arcs(std::span<const Facing> facing, const Sector& sector) {
    std::vector<Arc> arcs;
    arcs.reserve(facing.size());
    const Direction right{sector.right}, left{sector.left};
    for (std::uint32_t i = 0; i < facing.size(); ++i) {
        const Vec<2>&a = facing[i].right, &b = facing[i].left;
        Arc arc{right, left, i};
        if (inside(sector, a)) {
            arc.from = Direction{a};
        } else if (!on_border(sector.eye, sector.right, a)) {
            const bool over_right = orient(sector.eye, a, sector.right) > 0 && orient(sector.eye, sector.right, b) > 0;
            if (!over_right) continue;
        }
        if (orient(sector.eye, sector.left, b) < 0) arc.to = Direction{b};
        arcs.push_back(arc);
    }
    return arcs;
}

int turn_between_crossings(const Vec<2>& eye, std::span<const Facing> facing, const Direction& d, const Direction& e) {
    if (!e.is_crossing()) return orient(eye, crossing_of(facing, d), e.point);
    if (!d.is_crossing()) return -orient(eye, crossing_of(facing, e), d.point);
    if (d.first == e.first && d.second == e.second) return 0;
    return orient(eye, crossing_of(facing, d), crossing_of(facing, e));
}

Vec<2> point_on(std::span<const Facing> facing, std::uint32_t index, const Vec<2>& eye, const Direction& direction) {
    const Facing& f = facing[index];
    const Segment segment{f.right, f.left};
    if (!direction.is_crossing()) {
        if (direction.point == f.right || direction.point == f.left) return direction.point;
        return hit(segment, eye, direction.point);
    }
    const std::uint32_t other = direction.first == index    ? direction.second
                                : direction.second == index ? direction.first
                                                            : none;
    if (other == none) return hit(segment, eye, crossing_of(facing, direction));
    return rounded({segment, {facing[other].right, facing[other].left}});
}

}  // namespace sightline
