// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/viewpoint_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/draw/palette.h"
#include "core/draw/viewpoint_map.h"

namespace sightline {

namespace {

/// Of the plan's longer side: lines of the scene that are shorter say nothing.
constexpr double shortest_cut = 1.0 / 250;
/// Of the scene's height, where an eye above everything has the scene cut.
constexpr double near_ground = 0.1;

/// What a triangle and a level plane have in common; nothing where they only touch.
std::optional<std::array<Vec<3>, 2>> cut_at(const Primitive<3>& triangle, int up, double height) {
    std::array<Vec<3>, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3 && count < 2; ++i) {
        const Vec<3>&a = triangle[i], &b = triangle[(i + 1) % 3];
        const double from = a[up] - height, to = b[up] - height;
        if ((from < 0) != (to < 0)) ends[count++] = a + (b - a) * (from / (from - to));
    }
    if (count < 2) return std::nullopt;
    return ends;
}

/// How many lines were drawn.
std::size_t add_cut(const Scene<3>& scene, double height, double shortest, RegionPainter<3>& painter) {
    std::size_t drawn = 0;
    for (const Primitive<3>& triangle : scene.primitives) {
        const auto ends = cut_at(triangle, scene.up_axis, height);
        if (!ends) continue;
        const Vec<2> a = painter.in_plan((*ends)[0]), b = painter.in_plan((*ends)[1]);
        if (!(glm::length(b - a) >= shortest)) continue;
        painter.wall(a, b);
        ++drawn;
    }
    return drawn;
}

/// The two sides of the cone as far as the plan reaches, and the eye.
void add_view(const View<3>& view, const RegionPainter<3>& painter, DrawList& list) {
    const Vec<2> eye = painter.in_plan(view.eye);
    const double reach = 3 * list.world.longest_side() + glm::length(eye - list.world.centre());
    for (const auto& [low, high] : {std::pair(0, 3), std::pair(1, 2)}) {
        const Vec<3> middle =
            (view.corners[static_cast<std::size_t>(low)] + view.corners[static_cast<std::size_t>(high)]) * 0.5;
        const Vec<2> along = painter.in_plan(middle) - eye;
        const double length = glm::length(along);
        if (length > 0)
            list.add(ShapeKind::polyline, static_cast<std::uint16_t>(Look::view),
                     {eye, eye + along * (reach / length)});
    }
    list.add(ShapeKind::disc, static_cast<std::uint16_t>(Look::eye), {eye}, 2.6);
}

}  // namespace

std::optional<ViewpointPlan> viewpoint_plan(const Session<3>& session) {
    const auto fact = shown_viewpoint(session);
    if (!fact) return std::nullopt;
    const Scene<3>& scene = session.scene();
    const View<3>& view = session.problem().view;
    const int up = scene.up_axis;
    ViewpointPlan plan;
    DrawList& list = plan.list;
    list.styles = colours(session.settings().palette).looks;
    RegionPainter<3> painter(*fact, scene, session.settings().palette, list);
    Box<3> space;
    for (const RegionFact<3>& region : fact->map) {
        space.add(region.box.min);
        space.add(region.box.max);
    }
    list.world.add(painter.in_plan(space.min));
    list.world.add(painter.in_plan(space.max));
    // An eye outside belongs to the nearest region.
    const double height = std::clamp(view.eye[up], space.min[up], space.max[up]);
    painter.regions(height);
    const Box<3> all = bounds<3>(scene.primitives);
    const double shortest = shortest_cut * list.world.longest_side();
    if (add_cut(scene, height, shortest, painter) == 0 && !all.empty())
        add_cut(scene, all.min[up] + near_ground * all.extent()[up], shortest, painter);
    painter.outline();
    add_view(view, painter, list);
    painter.rose(view.eye, 0.13 * list.world.longest_side());
    plan.title = "plan at the eye's height: " + fact->techniques[fact->done].name;
    return plan;
}

}  // namespace sightline
