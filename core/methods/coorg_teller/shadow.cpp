// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/shadow.h"

#include <algorithm>

namespace sightline {

namespace {

/// More than products of coordinates lose when they underflow.
constexpr double least_product = 1e-300;
/// Twice what ViewPlane's bound is made of (view.cpp: 8 u for the normal, the difference, three products and two sums),
/// and a difference more for the offset.
constexpr double rounding = 0x1p-48;

/// Through the eye and an edge, seen from the eye as running from a to b with the inside on its left.
ShadowPlane<3> plane_through(const Vec<3>& eye, const Vec<3>& a, const Vec<3>& b) {
    const Vec<3> u = b - eye, v = a - eye;
    const Vec<3> p(u.y * v.z, u.z * v.x, u.x * v.y), r(u.z * v.y, u.x * v.z, u.y * v.x);
    return {p - r, (glm::abs(p) + glm::abs(r)) * rounding, 0, 0};
}

/// Through the eye and a; the inside is on the left, or on the right where it is the left end.
ShadowPlane<2> plane_through(const Vec<2>& eye, const Vec<2>& a, bool left_end) {
    const Vec<2> u = a - eye;
    const Vec<2> inward = left_end ? Vec<2>(u.y, -u.x) : Vec<2>(-u.y, u.x);
    return {inward, glm::abs(inward) * rounding, 0, 0};
}

template <int D>
void set_offset(ShadowPlane<D>& plane, const Vec<D>& to_plane) {
    plane.offset = glm::dot(plane.inward, to_plane);
    plane.offset_uncertainty = glm::dot(plane.uncertainty, glm::abs(to_plane));
}

ShadowPlane<3> front_plane(const Vec<3>& eye, const Primitive<3>& t, bool from_behind) {
    const Vec<3> u = t[1] - t[0], v = t[2] - t[0];
    const Vec<3> p(u.y * v.z, u.z * v.x, u.x * v.y), r(u.z * v.y, u.x * v.z, u.y * v.x);
    ShadowPlane<3> plane{from_behind ? p - r : r - p, (glm::abs(p) + glm::abs(r)) * rounding, 0, 0};
    set_offset(plane, t[0] - eye);
    return plane;
}

/// `from_behind`: the eye lies on the right of the way from start to end.
ShadowPlane<2> front_plane(const Vec<2>& eye, const Primitive<2>& s, bool from_behind) {
    const Vec<2> along = s[1] - s[0];
    const Vec<2> left(-along.y, along.x);
    ShadowPlane<2> plane{from_behind ? left : -left, glm::abs(left) * rounding, 0, 0};
    set_offset(plane, s[0] - eye);
    return plane;
}

/// The exact side of a corner: as the plane has it.
int exact_side(const ShadowSide<2>& side, const Vec<2>& eye, const Vec<2>& corner) {
    const int left = orient(eye, side.a, corner);
    return side.reversed ? -left : left;
}
int exact_side(const ShadowSide<3>& side, const Vec<3>& eye, const Vec<3>& corner) {
    return orient(side.a, side.b, corner, eye);
}
int exact_side(const ShadowFront<2>& front, const Scene<2>& scene, const Vec<2>& corner) {
    const Primitive<2>& s = scene.primitives[front.primitive];
    const int left = orient(s[0], s[1], corner);
    return front.from_behind ? left : -left;
}
int exact_side(const ShadowFront<3>& front, const Scene<3>& scene, const Vec<3>& corner) {
    const Primitive<3>& t = scene.primitives[front.primitive];
    const int before = orient(t[0], t[1], t[2], corner);
    return front.from_behind ? before : -before;
}

/// The least and the largest value of a plane over the corners of a box, and how uncertain both are. The corners are
/// found by the signs of the plane's normal: the look-up table of CT section 2.1.
struct Range {
    double low = 0, high = 0, uncertainty = 0;
};
template <int D>
Range range_over(const ShadowPlane<D>& plane, const EyeBox<D>& box) {
    Range range{-plane.offset, -plane.offset, plane.offset_uncertainty + least_product};
    for (int i = 0; i < D; ++i) {
        const double at_low = plane.inward[i] * box.low[i], at_high = plane.inward[i] * box.high[i];
        range.low += std::min(at_low, at_high);
        range.high += std::max(at_low, at_high);
        range.uncertainty += plane.uncertainty[i] * box.reach[i];
    }
    return range;
}

/// Of a polygon, corner by corner.
template <int D>
Range range_over(const ShadowPlane<D>& plane, const EyePolygon<D>& polygon) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Range range{far, -far, 0};
    for (const Vec<D>& corner : polygon.corners) {
        const Vec<D> q = corner - polygon.eye;
        const double value = glm::dot(plane.inward, q) - plane.offset;
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
        range.uncertainty = std::max(range.uncertainty, glm::dot(plane.uncertainty, glm::abs(q)));
    }
    range.uncertainty += plane.offset_uncertainty + least_product;
    return range;
}

template <typename Occludee, typename Exact>
CornerSides signs(const Range& range, const Occludee& occludee, Exact exact) {
    const auto sure = [&](double value) { return value > range.uncertainty ? 1 : value < -range.uncertainty ? -1 : 0; };
    CornerSides found{sure(range.low), sure(range.high)};
    if (found.low != 0 && found.high != 0) return found;
    found = {1, -1};
    for (const auto& corner : corners_of(occludee)) {
        const int side = exact(corner);
        found.low = std::min(found.low, side);
        found.high = std::max(found.high, side);
    }
    return found;
}

template <int D, typename Occludee>
CornerSides signs_of(const ShadowSide<D>& side, const Occludee& occludee, const Range& range) {
    return signs(range, occludee, [&](const Vec<D>& corner) { return exact_side(side, occludee.eye, corner); });
}

template <int D, typename Occludee>
CornerSides signs_of(const ShadowFront<D>& front, const Scene<D>& scene, const Occludee& occludee) {
    return signs(range_over(front.plane, occludee), occludee,
                 [&](const Vec<D>& corner) { return exact_side(front, scene, corner); });
}

/// A bound from below on the distance of the eye from the planes through the side's edge and a corner, where the value
/// of the plane through the eye is at least `value` for each such corner: the value is the volume of edge, corner and
/// eye (2D: the area), and the base of that is no larger than length times reach.
template <int D, typename Occludee>
double distance_of_eye(const ShadowSide<D>& side, const Occludee& occludee, double value) {
    if (!(value > 0)) return 0;
    const Vec<D> away = occludee.centre - side.a;
    const double reach = std::sqrt(glm::dot(away, away)) + occludee.half_diagonal;
    return value / (side.length * reach);
}

template <int D, typename Occludee>
Relation relation_of(const Shadow<D>& shadow, const Scene<D>& scene, const Occludee& occludee,
                     std::uint64_t& products) {
    Relation result;
    result.beyond = true;
    // The occluder's planes stay where they are when the eye moves.
    constexpr double for_ever = std::numeric_limits<double>::infinity();
    for (const ShadowFront<D>& front : shadow.fronts) {
        ++products;
        const CornerSides beyond = signs_of(front, scene, occludee);
        if (beyond.high <= 0) return {Region::visible, false, for_ever};
        if (beyond.low <= 0) result.beyond = false;
    }
    bool all = true;
    double separating = for_ever, supporting = for_ever, failing = 0;
    for (std::size_t i = 0; i < shadow.sides.size(); ++i) {
        const ShadowSide<D>& side = shadow.sides[i];
        ++products;
        const Range range = range_over(side.plane, occludee);
        const CornerSides inside = signs_of(side, occludee, range);
        if (inside.high <= 0)
            return {Region::visible, result.beyond, distance_of_eye(side, occludee, -range.high - range.uncertainty)};
        separating = std::min(separating, distance_of_eye(side, occludee, range.high - range.uncertainty));
        if (inside.low >= 0) {
            supporting = std::min(supporting, distance_of_eye(side, occludee, range.low - range.uncertainty));
        } else {
            all = false;
            failing = std::max(failing, distance_of_eye(side, occludee, -range.low - range.uncertainty));
        }
    }
    if (all && result.beyond) {
        result.region = Region::hidden;
        result.slack = supporting;
        return result;
    }
    result.region = Region::partial;
    // Not hidden while one plane that is not satisfied stays so, or as long as a part of the box is not beyond.
    result.slack = result.beyond ? std::min(separating, failing) : separating;
    return result;
}

}  // namespace

template <int D>
EyeBox<D>::EyeBox(const Box<D>& of, const Vec<D>& from) : box(of), eye(from), low(of.min - from), high(of.max - from) {
    reach = glm::max(glm::abs(low), glm::abs(high));
    const Vec<D> extent = high - low;
    half_diagonal = std::sqrt(glm::dot(extent, extent)) / 2;
    centre = of.centre();
}

template <int D>
EyePolygon<D>::EyePolygon(std::span<const Vec<D>> of, const Vec<D>& from) : corners(of), eye(from) {
    Box<D> box;
    for (const Vec<D>& corner : of) box.add(corner);
    const Vec<D> extent = box.extent();
    centre = box.centre();
    half_diagonal = std::sqrt(glm::dot(extent, extent)) / 2;
}

template <int D>
CornerSides corner_sides(const ShadowSide<D>& side, const EyeBox<D>& box) {
    return signs_of(side, box, range_over(side.plane, box));
}

template <int D>
CornerSides corner_sides(const ShadowFront<D>& front, const Scene<D>& scene, const EyeBox<D>& box) {
    return signs_of(front, scene, box);
}

template <int D, typename Occludee>
std::pair<bool, double> supporting_plane(const ShadowSide<D>& side, const Occludee& occludee) {
    const Range range = range_over(side.plane, occludee);
    const bool satisfied = signs_of(side, occludee, range).low >= 0;
    return {satisfied, distance_of_eye(side, occludee, (satisfied ? range.low : -range.low) - range.uncertainty)};
}

template <int D>
int side_seen(const Scene<D>& scene, const Polygons<D>& polygons, std::uint32_t polygon, const Vec<D>& eye) {
    int seen = 0;
    for (const std::uint32_t primitive : polygons.planes_of(polygon)) {
        const Primitive<D>& p = scene.primitives[primitive];
        int here;
        if constexpr (D == 2)
            here = orient(p[0], p[1], eye);
        else
            here = orient(p[0], p[1], p[2], eye);
        if (here == 0 || (seen != 0 && here != seen)) return 0;
        seen = here;
    }
    return seen < 0 && !polygons.two_sided[polygon] ? 0 : seen;
}

template <int D>
void make_shadow(const Scene<D>& scene, const Polygons<D>& polygons, std::span<const std::uint32_t> of,
                 const Vec<D>& eye, Shadow<D>& shadow) {
    shadow.sides.clear();
    shadow.fronts.clear();
    shadow.polygons.assign(of.begin(), of.end());
    for (const std::uint32_t polygon : of) {
        const bool behind = side_seen(scene, polygons, polygon, eye) < 0;
        for (const std::uint32_t primitive : polygons.planes_of(polygon))
            shadow.fronts.push_back({front_plane(eye, scene.primitives[primitive], behind), primitive, behind});
        const auto sides = polygons.sides_of(polygon);
        const std::uint32_t first = polygons.side_begin[polygon];
        for (std::uint32_t i = 0; i < sides.size(); ++i) {
            ShadowSide<D> side;
            side.polygon = polygon;
            side.side = first + i;
            side.edge = sides[i].edge;
            side.a = polygons.points[sides[i].point];
            if constexpr (D == 2) {
                // From the left of the way from start to end, the start is on the right.
                side.reversed = (i == 0) == behind;
                side.plane = plane_through(eye, side.a, side.reversed);
            } else {
                side.b = polygons.points[sides[i + 1 < sides.size() ? i + 1 : 0].point];
                side.reversed = sides[i].reversed != behind;
                if (behind) std::swap(side.a, side.b);
                side.plane = plane_through(eye, side.a, side.b);
                side.length = std::sqrt(glm::dot(side.b - side.a, side.b - side.a));
            }
            // An edge that another one of them runs along the other way is an inner one.
            const auto other = std::find_if(shadow.sides.begin(), shadow.sides.end(), [&](const ShadowSide<D>& s) {
                return s.polygon != polygon && s.edge == side.edge && s.reversed != side.reversed;
            });
            if (other != shadow.sides.end())
                shadow.sides.erase(other);
            else
                shadow.sides.push_back(side);
        }
    }
}

template <int D>
Relation relation(const Shadow<D>& shadow, const Scene<D>& scene, const EyeBox<D>& box, std::uint64_t& products) {
    return relation_of(shadow, scene, box, products);
}

template <int D>
Relation relation(const Shadow<D>& shadow, const Scene<D>& scene, const EyePolygon<D>& polygon,
                  std::uint64_t& products) {
    return relation_of(shadow, scene, polygon, products);
}

#define SIGHTLINE_INSTANTIATE(D)                                                                                     \
    template std::pair<bool, double> supporting_plane<D, EyeBox<D>>(const ShadowSide<D>&, const EyeBox<D>&);         \
    template std::pair<bool, double> supporting_plane<D, EyePolygon<D>>(const ShadowSide<D>&, const EyePolygon<D>&); \
    template struct EyePolygon<D>;                                                                                   \
    template struct EyeBox<D>;                                                                                       \
    template CornerSides corner_sides<D>(const ShadowSide<D>&, const EyeBox<D>&);                                    \
    template CornerSides corner_sides<D>(const ShadowFront<D>&, const Scene<D>&, const EyeBox<D>&);                  \
    template int side_seen<D>(const Scene<D>&, const Polygons<D>&, std::uint32_t, const Vec<D>&);                    \
    template void make_shadow<D>(const Scene<D>&, const Polygons<D>&, std::span<const std::uint32_t>, const Vec<D>&, \
                                 Shadow<D>&);                                                                        \
    template Relation relation<D>(const Shadow<D>&, const Scene<D>&, const EyeBox<D>&, std::uint64_t&);              \
    template Relation relation<D>(const Shadow<D>&, const Scene<D>&, const EyePolygon<D>&, std::uint64_t&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
