// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/paint_rooms.h"

#include "core/draw/palette.h"
#include "core/methods/portals/portal_run.h"

namespace sightline {

namespace {

/// What of a convex polygon lies on the left of a line; rounded.
std::vector<Vec<2>> left_of(const std::vector<Vec<2>>& polygon, const Vec<2>& a, const Vec<2>& b) {
    std::vector<Vec<2>> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<2>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) != (at_q >= 0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
    return kept;
}

}  // namespace

bool walks_rooms(const Session<2>& session) {
    const Kind pops = session.method().pops;
    return !session.scene().rooms.empty() && (pops == Kind::portal || pops == Kind::region);
}

void paint_windows(const Session<2>& session, DrawList& list) {
    const std::vector<Room<2>>& rooms = session.scene().rooms.all;
    const Run<2>& run = session.traversal();
    const auto paint = [&](const std::vector<Vec<2>>& outline, CellState state) {
        if (outline.size() < 3 || state == CellState::clean) return;
        const Look look = state == CellState::projected ? Look::projected : Look::enqueued;
        list.add(ShapeKind::polygon, static_cast<std::uint16_t>(look), outline);
    };
    const auto* const walk = dynamic_cast<const PortalRun<2>*>(&run);
    if (!walk) {  // rooms as wholes
        for (std::uint32_t room = 0; room < rooms.size(); ++room)
            paint(rooms[room].shape, run.mark({room, Kind::region}).state);
        return;
    }
    const Vec<2>& eye = session.culling_view().eye;
    std::uint32_t left = run.steps();
    for (const RoomVisit<2>& visit : walk->visits()) {
        const CellState state = left > 0 ? CellState::projected : CellState::enqueued;
        left -= left > 0;
        if (visit.room >= rooms.size()) continue;
        std::vector<Vec<2>> outline = rooms[visit.room].shape;
        if (!visit.window.all) outline = left_of(left_of(outline, eye, visit.window.right), visit.window.left, eye);
        paint(outline, state);
    }
}

void paint_portals(const Session<2>& session, DrawList& list) {
    Style style{"portal"};
    style.stroke = list.styles[static_cast<std::size_t>(Look::note)].stroke;
    if (style.stroke.a == 0) style.stroke = colours(session.settings().palette).ink;
    style.width_pt = 0.8;
    style.dash = Dash::dashed;
    const auto index = static_cast<std::uint16_t>(list.styles.size());
    list.styles.push_back(style);
    for (const Portal<2>& portal : session.scene().rooms.portals)
        list.add(ShapeKind::polyline, index, {portal.corners[0], portal.corners[1]});
}

}  // namespace sightline
