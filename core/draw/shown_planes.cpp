// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/shown_planes.h"

#include <algorithm>
#include <cmath>

#include "core/draw/shown_boxes.h"
#include "core/draw/viewpoint_map.h"
#include "core/session/explain_box.h"
#include "core/space/box_tree.h"

namespace sightline {

namespace {

/// Positive on the left of the way from its first point to the second.
double side_of(const TestedPlane<2>& plane, const Vec<2>& p) {
    return cross(plane.points[1] - plane.points[0], p - plane.points[0]);
}

/// The side on which it is satisfied, as a sign of side_of(); 0: the eye is on the line, which then says nothing.
double good_side(const TestedPlane<2>& plane, const Vec<2>& eye) {
    const double side = side_of(plane, eye);
    return side == 0 ? 0 : (side > 0) == plane.satisfied ? 1 : -1;
}

/// What of a convex polygon lies where side * side_of() is not negative.
std::vector<Vec<2>> cut(const std::vector<Vec<2>>& polygon, const TestedPlane<2>& plane, double side) {
    std::vector<Vec<2>> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<2>&a = polygon[i], &b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        const double at_a = side * side_of(plane, a), at_b = side * side_of(plane, b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    return kept;
}

}  // namespace

template <int D>
std::uint32_t box_at_hand(const Session<D>& session) {
    if (!walks_boxes(session)) return none;
    const Run<D>& run = session.traversal();
    if (session.selected_node < run.boxes()->nodes.size()) return session.selected_node;
    const std::uint32_t primitive = session.selected_primitive;
    if (primitive != none && !is_of_occluder(session, primitive, true)) return box_around(session, primitive);
    return last_node(session);
}

template <int D>
std::optional<Box<D>> explained_box(const Session<D>& session) {
    const std::uint32_t node = box_at_hand(session);
    if (node == none || (node == last_node(session) && node != session.selected_node)) return std::nullopt;
    return session.traversal().boxes()->nodes[node].box;
}

template <int D>
bool is_of_occluder(const Session<D>& session, std::uint32_t primitive, bool actual) {
    for (const OccluderFact& occluder : session.traversal().occluders())
        if ((occluder.actual || !actual) &&
            std::find(occluder.primitives.begin(), occluder.primitives.end(), primitive) != occluder.primitives.end())
            return true;
    return false;
}

std::vector<OccluderFact> marked_occluders(const Session<3>& session) {
    std::vector<OccluderFact> all =
        session.traversal().tests_planes() ? session.traversal().occluders() : std::vector<OccluderFact>{};
    if (const auto viewpoint = shown_viewpoint(session))
        for (const std::uint32_t primitive : viewpoint->occluders) all.push_back({{primitive}});
    return all;
}

bool marks_occluders(const Session<3>& session) {
    return session.traversal().tests_planes() || !marked_occluders(session).empty();
}

template <int D>
std::uint32_t occluder_at_hand(const Session<D>& session) {
    const std::uint32_t primitive = session.selected_primitive;
    return primitive != none && is_of_occluder(session, primitive, true) ? primitive : none;
}

template <int D>
std::vector<TestedPlane<D>> planes_at_hand(const Session<D>& session) {
    const Run<D>& run = session.traversal();
    if (!run.tests_planes()) return {};
    const std::uint32_t node = box_at_hand(session);
    if (node == none) return {};
    const Item box{node, Kind::node};
    const CellState state = run.mark(box).state;
    if (state == CellState::clean || state == CellState::unseen) return {};
    return run.tested_planes(box, occluder_at_hand(session));
}

template <int D>
std::optional<OccluderRegion<D>> region_at_hand(const Session<D>& session) {
    const std::uint32_t primitive = session.selected_primitive;
    if (primitive == none || !session.traversal().tests_planes() || !is_of_occluder(session, primitive, false))
        return std::nullopt;
    return session.traversal().occluder_region(primitive);
}

EyeRegions eye_regions(const std::vector<TestedPlane<2>>& planes, const Vec<2>& eye, const Box<2>& world) {
    std::vector<const TestedPlane<2>*> own, supporting, separating;
    for (const TestedPlane<2>& plane : planes)
        (plane.kind == PlaneKind::own          ? own
         : plane.kind == PlaneKind::supporting ? supporting
                                               : separating)
            .push_back(&plane);
    if (own.size() != 1 || supporting.size() != 2 || separating.size() != 2 || !own[0]->satisfied) return {};
    for (const TestedPlane<2>& plane : planes)
        if (good_side(plane, eye) == 0) return {};
    const auto corners = world.corners();
    // Satisfied says of the occluder's own line that the box lies beyond: the eyes are on the eye's side of it.
    const std::vector<Vec<2>> before =
        cut({corners.begin(), corners.end()}, *own[0], side_of(*own[0], eye) > 0 ? 1 : -1);
    EyeRegions regions;
    regions.partial = before;
    for (const TestedPlane<2>* plane : separating) {
        regions.parts_1.push_back(cut(before, *plane, -good_side(*plane, eye)));
        regions.partial = cut(regions.partial, *plane, good_side(*plane, eye));
    }
    regions.hidden = regions.partial;
    for (const TestedPlane<2>* plane : supporting) {
        regions.parts_2.push_back(cut(regions.partial, *plane, -good_side(*plane, eye)));
        regions.hidden = cut(regions.hidden, *plane, good_side(*plane, eye));
    }
    return regions;
}

Middle middle_of(const std::vector<Vec<2>>& polygon) {
    Middle middle;
    Vec<2> sum{};
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const double area = cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]) / 2;
        middle.area += area;
        sum += (polygon[0] + polygon[i] + polygon[i + 1]) * (area / 3);
    }
    if (middle.area != 0) middle.at = sum / middle.area;
    middle.area = std::abs(middle.area);
    return middle;
}

std::array<Vec<3>, 4> piece_of(const TestedPlane<3>& plane, const Vec<3>& eye) {
    const auto& [a, b, corner] = plane.points;
    const Vec<3> middle = (a + b) * 0.5, along = b - a, across = corner - middle;
    const double length2 = glm::dot(along, along);
    const Vec<3> out = length2 > 0 ? across - along * (glm::dot(across, along) / length2) : across;
    const double out2 = glm::dot(out, out);
    const double back = out2 > 0 ? std::clamp(glm::dot(eye - middle, out) / out2, -4.0, 0.0) : 0;
    const Vec<3> shift = corner - middle - out;  // along the edge, so that the piece goes through the corner
    const Vec<3> far = out * 1.15 + shift, near = (out + shift) * back;
    return {a + near, b + near, b + far, a + far};
}

#define SIGHTLINE_INSTANTIATE(D)                                               \
    template std::uint32_t box_at_hand<D>(const Session<D>&);                  \
    template std::optional<Box<D>> explained_box<D>(const Session<D>&);        \
    template bool is_of_occluder<D>(const Session<D>&, std::uint32_t, bool);   \
    template std::uint32_t occluder_at_hand<D>(const Session<D>&);             \
    template std::vector<TestedPlane<D>> planes_at_hand<D>(const Session<D>&); \
    template std::optional<OccluderRegion<D>> region_at_hand<D>(const Session<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
