// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/paint_rooms.h"

#include "core/draw/palette.h"

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

void paint_windows(const Session<2>& session, DrawList& list) {
    const std::vector<Room<2>>& rooms = session.scene().rooms.all;
    const Vec<2>& eye = session.culling_view().eye;
    for (const RoomSeen<2>& seen : session.traversal().rooms_seen().value_or(std::vector<RoomSeen<2>>{})) {
        std::vector<Vec<2>> outline = rooms[seen.room].shape;
        if (!seen.whole) outline = left_of(left_of(outline, eye, seen.window.corners[0]), seen.window.corners[1], eye);
        if (outline.size() < 3) continue;
        const Look look = seen.state == CellState::projected ? Look::projected : Look::enqueued;
        list.add(ShapeKind::polygon, static_cast<std::uint16_t>(look), outline);
    }
}

std::vector<CellState> states_of_rooms(const Session<3>& session) {
    std::vector<CellState> states(session.scene().rooms.all.size(), CellState::clean);
    const auto all = session.traversal().rooms_seen();
    if (!all) return states;
    for (const RoomSeen<3>& seen : *all)
        if (states[seen.room] != CellState::projected) states[seen.room] = seen.state;
    return states;
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
