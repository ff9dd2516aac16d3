// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/box_planes.h"

#include <algorithm>

namespace sightline {

namespace {

/// The side of the plane through the shadow's edge and `through` on which p lies.
int side_of(const ShadowSide<2>& side, const Vec<2>& through, const Vec<2>& p) { return orient(side.a, through, p); }
int side_of(const ShadowSide<3>& side, const Vec<3>& through, const Vec<3>& p) {
    return orient(side.a, side.b, through, p);
}

double distance_to(const ShadowSide<2>& side, const Vec<2>& through, const Vec<2>& p) {
    const Vec<2> along = through - side.a;
    return std::abs(cross(along, p - side.a)) / std::sqrt(glm::dot(along, along));
}
double distance_to(const ShadowSide<3>& side, const Vec<3>& through, const Vec<3>& p) {
    const Vec<3> normal = glm::cross(side.b - side.a, through - side.a);
    return std::abs(glm::dot(normal, p - side.a)) / std::sqrt(glm::dot(normal, normal));
}

std::array<Vec<2>, 2> points_of(const ShadowSide<2>& side, const Vec<2>& corner) { return {side.a, corner}; }
std::array<Vec<3>, 3> points_of(const ShadowSide<3>& side, const Vec<3>& corner) { return {side.a, side.b, corner}; }

/// How far before (negative) or beyond the primitive's plane, as the eye sees it, the box's nearest corner lies.
template <int D>
double least_beyond(const ShadowFront<D>& front, const Box<D>& box, const Vec<D>& eye) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec<D>& corner : box.corners())
        least = std::min(least, glm::dot(front.plane.inward, corner - eye) - front.plane.offset);
    return least / std::sqrt(glm::dot(front.plane.inward, front.plane.inward));
}

}  // namespace

template <int D>
std::vector<TestedPlane<D>> box_planes(const Shadow<D>& shadow, const Polygons<D>& polygons, const Scene<D>& scene,
                                       const Box<D>& box, const Vec<D>& eye) {
    std::vector<TestedPlane<D>> planes;
    std::uint32_t number = 0;
    for (const ShadowFront<D>& front : shadow.fronts) {
        TestedPlane<D> plane{PlaneKind::own, number++, scene.primitives[front.primitive], false, 0};
        plane.satisfied = corner_sides(front, scene, EyeBox<D>(box, eye)).low > 0;
        // The rounded distance may say otherwise by a rounding error.
        const double beyond = least_beyond(front, box, eye);
        plane.distance = plane.satisfied ? std::max(beyond, 0.0) : std::min(beyond, 0.0);
        planes.push_back(plane);
    }
    const EyeBox<D> seen(box, eye);
    const auto corners = box.corners();
    number = 0;
    for (const ShadowSide<D>& side : shadow.sides) {
        // A corner of its polygon off the edge: on which side of a plane through the edge the occluder lies.
        const std::vector<Vec<D>> own = polygons.corners_of(side.polygon);
        const CornerSides decided = corner_sides(side, seen);
        for (const PlaneKind kind : {PlaneKind::supporting, PlaneKind::separating}) {
            // As the test decides it; where the box lies beyond the occluder, that is: the eye lies on the occluder's
            // side of the plane.
            const bool satisfied = kind == PlaneKind::supporting ? decided.low >= 0 : decided.high > 0;
            const auto touches = [&](const Vec<D>& corner) {
                int occluder = 0;
                for (const Vec<D>& p : own)
                    if (occluder == 0) occluder = side_of(side, corner, p);
                const int wanted = kind == PlaneKind::supporting ? occluder : -occluder;
                return wanted != 0 && std::all_of(corners.begin(), corners.end(), [&](const Vec<D>& other) {
                           return side_of(side, corner, other) * wanted >= 0;
                       });
            };
            auto corner = std::find_if(corners.begin(), corners.end(), touches);
            if (corner == corners.end()) {
                if (satisfied) continue;
                corner = std::min_element(corners.begin(), corners.end(), [&](const Vec<D>& a, const Vec<D>& b) {
                    return glm::dot(side.plane.inward, a - eye) < glm::dot(side.plane.inward, b - eye);
                });
            }
            const double distance = distance_to(side, *corner, eye);
            planes.push_back({kind, number, points_of(side, *corner), satisfied, satisfied ? distance : -distance});
        }
        ++number;
    }
    return planes;
}

template <int D>
Shadow<D> joint_shadow(const BoxStates<D>& states, const Polygons<D>& polygons, const Scene<D>& scene,
                       std::span<const std::uint32_t> slots, const Vec<D>& eye) {
    std::vector<std::uint32_t> members;
    for (const std::uint32_t slot : slots) {
        const auto& of = states.shadows()[slot].polygons;
        members.insert(members.end(), of.begin(), of.end());
    }
    Shadow<D> joint;
    make_shadow<D>(scene, polygons, members, eye, joint);
    if (D == 2 && states.connected() == Connected::fused) {
        joint.sides.clear();
        for (const bool left_end : {false, true})
            for (const ShadowSide<D>& side : states.shadows()[left_end ? slots.back() : slots.front()].sides)
                if (side.reversed == left_end) joint.sides.push_back(side);
    }
    return joint;
}

template <int D>
std::uint32_t best_occluder(const BoxStates<D>& states, std::uint32_t node, std::span<const std::uint32_t> slots) {
    std::uint32_t best = none;
    Relation relation_of_best;
    std::size_t fewest = 0;
    for (const std::uint32_t slot : slots) {
        const Relation found = states.relation_to(node, slot);
        if (found.region == Region::hidden) return slot;
        const bool hides_part = found.region == Region::partial;
        const Shadow<D>& shadow = states.shadows()[slot];
        std::size_t missing = found.beyond ? 0 : shadow.sides.size();
        for (const ShadowSide<D>& side : shadow.sides) {
            const CornerSides corners = corner_sides(side, states.seen(node));
            missing += hides_part ? corners.low < 0 : corners.high <= 0;
        }
        const bool best_hides_part = relation_of_best.region == Region::partial;
        const bool is_better = best == none || hides_part != best_hides_part ? best == none || hides_part
                               : missing != fewest                           ? missing < fewest
                                                   : shadow.area_angle > states.shadows()[best].area_angle;
        if (!is_better) continue;
        best = slot;
        relation_of_best = found;
        fewest = missing;
    }
    return best;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                              \
    template std::vector<TestedPlane<D>> box_planes<D>(const Shadow<D>&, const Polygons<D>&, const Scene<D>&, \
                                                       const Box<D>&, const Vec<D>&);                         \
    template Shadow<D> joint_shadow<D>(const BoxStates<D>&, const Polygons<D>&, const Scene<D>&,              \
                                       std::span<const std::uint32_t>, const Vec<D>&);                        \
    template std::uint32_t best_occluder<D>(const BoxStates<D>&, std::uint32_t, std::span<const std::uint32_t>);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
