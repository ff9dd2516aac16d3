// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/shown_world.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/draw/eye_strip.h"
#include "core/draw/notes.h"

namespace sightline {

namespace {

/// The whole scene with the eye, a margin, and room for the strip of what the eye sees.
Box<2> whole_world(const Session<2>& session) {
    Box<2> box = bounds<2>(session.scene().primitives);
    const Vec<2>& eye = session.display_view().eye;
    box.add(eye);
    const double side = box.longest_side();
    // Nothing but the eye: room to draw in, which does not vanish beside its coordinates.
    const double room = 10 * glm::length(session.display_view().look_at - eye);
    const Vec<2> margin(side > 0 ? side * 0.05 : std::max({room, std::abs(eye.x) * 0.05, std::abs(eye.y) * 0.05}));
    Box<2> world{box.min - margin, box.max + margin};
    const Settings& settings = session.settings();
    if (settings.show_eye == Switch::on) world.min.y -= eye_strip_room(world, settings.show_depth == Switch::on);
    return world;
}

}  // namespace

Box<2> shown_world(const Session<2>& session) {
    const Box<2> box = whole_world(session);
    const Settings& settings = session.settings();
    const Vec<2> half = box.extent() * (0.5 / settings.zoom);
    if (settings.zoom_at == ZoomAt::point) {
        const Vec<2> centre(settings.zoom_x, settings.zoom_y);
        return {centre - half, centre + half};
    }
    if (settings.zoom == 1) return box;
    std::uint32_t cell = none;
    if (settings.zoom_at == ZoomAt::last) cell = last_cell(session);
    if (settings.zoom_at == ZoomAt::selected) cell = session.selected_cell;
    // The eye stands off the middle, so that more of what it looks at is shown.
    const ViewSpec<2>& view = session.display_view();
    Vec<2> centre = view.eye + make_view(view).forward() * half * 0.6;
    if (cell != none)
        centre = session.cells().centre(cell);
    else if (settings.zoom > 1)
        centre = glm::clamp(centre, box.min + half, box.max - half);  // no room is lost beside the scene
    return {centre - half, centre + half};
}

Box<2> widened(Box<2> box, double aspect) {
    if (!(aspect > 0)) return box;
    const Vec<2> extent = box.extent();
    const Vec<2> more(std::max(0.0, extent.y * aspect - extent.x), std::max(0.0, extent.x / aspect - extent.y));
    box.min -= more * 0.5;
    box.max += more * 0.5;
    return box;
}

Box<2> figure_world(const Session<2>& session) {
    const Box<2> shown = shown_world(session);
    constexpr double widest_window = 2.5;
    const Box<2> beside = widened(shown, widest_window);
    Box<2> world = shown;
    for (const Note<2>& note : session.notes)
        if (const Vec<2> at = anchor_point(session, note); beside.contains(at)) world.add(at);
    return world;
}

}  // namespace sightline
