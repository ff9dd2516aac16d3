// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/zoom.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/trig.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_world.h"
#include "shell/desk/camera.h"
#include "shell/desk/change.h"
#include "shell/desk/moved.h"
#include "shell/desk/undo.h"

namespace sightline {

namespace {

/// Limits of the setting.
constexpr double least = 0.01, most = 1000;

}  // namespace

void zoom_about(Workbench<2>& bench, const Vec<2>& fixed, double factor, const std::string& gesture) {
    if (!(factor > 0)) throw InputError("the factor must be above 0");
    Settings settings = bench.session.settings();
    const double zoom = std::clamp(settings.zoom * factor, least, most);
    const Vec<2> middle = shown_world(bench.session).centre();
    const Vec<2> to = fixed + (middle - fixed) * (settings.zoom / zoom);
    settings.zoom = zoom;
    settings.zoom_at = ZoomAt::point;
    settings.zoom_x = to.x;
    settings.zoom_y = to.y;
    change_settings(bench, settings, gesture);
}

template <>
void zoom<2>(Workbench<2>& bench, double factor) {
    zoom_about(bench, shown_world(bench.session).centre(), factor);
}

template <>
void zoom<3>(Workbench<3>& bench, double factor) {
    if (!(factor > 0)) throw InputError("the factor must be above 0");
    change_view(bench, approached(bench.session.display_view(), factor));
}

template <>
void pan<2>(Workbench<2>& bench, const Vec<2>& shares) {
    const Box<2> world = shown_world(bench.session);
    centre_on(bench, world.centre() + shares * world.extent());
}

template <>
void pan<3>(Workbench<3>& bench, const Vec<2>& shares) {
    const ViewSpec<3>& view = bench.session.display_view();
    const SinCos half = sincos_degrees(view.fov / 2);
    const double tall = 2 * glm::length(view.look_at - view.eye) * half.sin / half.cos;
    change_view(bench, walked(view, bench.session.scene().up_axis, Vec<3>(shares * tall, 0)));
}

void centre_on(Workbench<2>& bench, const Vec<2>& middle, const std::string& gesture) {
    Settings settings = bench.session.settings();
    settings.zoom_at = ZoomAt::point;
    settings.zoom_x = middle.x;
    settings.zoom_y = middle.y;
    change_settings(bench, settings, gesture);
}

void hold(Workbench<2>& bench, const Box<2>& world, const std::string& gesture) {
    const Vec<2> shown = shown_world(bench.session).extent(), held = world.extent();
    const double factor = std::max(shown.x / held.x, shown.y / held.y);
    // Nothing that an eye could see: a picture that fits the scene goes on fitting it.
    const double off = glm::length(shown_world(bench.session).centre() - world.centre()) / glm::length(held);
    if (std::abs(factor - 1) < 1e-6 && off < 1e-6) return;
    zoom_about(bench, shown_world(bench.session).centre(), factor, gesture);
    centre_on(bench, world.centre(), gesture);
}

template <>
void fit<2>(Workbench<2>& bench) {
    Settings settings = bench.session.settings();
    settings.zoom = 1;
    settings.zoom_at = ZoomAt::view;
    change_settings(bench, settings);
}

template <int D>
Box<D> box_of_selection(const Workbench<D>& bench) {
    const Session<D>& session = bench.session;
    Box<D> box;
    if (session.selected_primitive != none) {
        for (const Vec<D>& corner : session.scene().primitives[session.selected_primitive]) box.add(corner);
    } else if (const auto node = selected_box(session)) {
        box = *node;
    } else if (session.selected_cell != none) {
        for (const std::uint32_t corner : session.cells().corners_of(session.selected_cell))
            box.add(session.cells().points[corner]);
    } else {
        throw InputError("select a cell, a box or a primitive first");
    }
    return box;
}
template Box<2> box_of_selection<2>(const Workbench<2>&);
template Box<3> box_of_selection<3>(const Workbench<3>&);

namespace {

/// With one longest side of room on every side, so that one sees where it is.
template <int D>
Box<D> with_room(Box<D> box) {
    const double room = std::max(box.longest_side(), 1e-6);
    box.min -= Vec<D>(room);
    box.max += Vec<D>(room);
    return box;
}

}  // namespace

template <>
void fit_selection<2>(Workbench<2>& bench) {
    hold(bench, with_room(box_of_selection(bench)));
}

namespace {

/// As the culling eye sees it, but turned where that eye sees a triangle at less than 30 degrees.
Vec<3> direction_to(const Session<3>& session, const Vec<3>& middle) {
    const Vec<3> there = middle - session.culling_view().eye;
    const double length = glm::length(there);
    if (!(length > 0)) return session.culling_view().look_at - session.culling_view().eye;
    Vec<3> along = there / length;
    if (session.selected_primitive == none) return along;
    const auto& [a, b, c] = session.scene().primitives[session.selected_primitive];
    Vec<3> normal = glm::cross(b - a, c - a);
    normal /= glm::length(normal);  // triangles of scenes have an area
    if (glm::dot(normal, along) > 0) normal = -normal;
    return glm::dot(normal, along) > -0.5 ? along - normal : along;
}

}  // namespace

template <>
void fit_selection<3>(Workbench<3>& bench) {
    const Box<3> box = with_room(box_of_selection(bench));
    remember(bench);
    Session<3>& session = bench.session;
    if (!session.frozen()) session.freeze();
    if (session.settings().projected_as == DrawnAs::solid) {  // they would fill the picture
        Settings settings = session.settings();
        settings.projected_as = DrawnAs::off;
        session.change(settings);
        bench.say("projected cells are hidden here: set projected_as=solid shows them");
    }
    const ImageSize size = image_size<3>(session.settings().reference_size);
    const Vec<3> middle = box.centre();
    session.set_view(outside({middle - direction_to(session, middle), middle, session.culling_view().fov}, box,
                             session.scene().up_axis, static_cast<double>(size.width) / size.height));
    moved(bench);
}

template <>
void fit<3>(Workbench<3>& bench) {
    const Session<3>& session = bench.session;
    if (session.scene().primitives.empty()) return;
    const ImageSize size = image_size<3>(session.settings().reference_size);
    change_view(bench, outside(session.display_view(), bounds<3>(session.scene().primitives), session.scene().up_axis,
                               static_cast<double>(size.width) / size.height));
}

}  // namespace sightline
