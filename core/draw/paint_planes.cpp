// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/paint_planes.h"

#include <algorithm>
#include <cmath>

#include "core/draw/palette.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_planes.h"
#include "core/space/box_tree.h"

namespace sightline {

namespace {

BoxLook plane_look(const TestedPlane<2>& plane) {
    switch (plane.kind) {
        case PlaneKind::supporting:
            return plane.satisfied ? BoxLook::supporting : BoxLook::supporting_fails;
        case PlaneKind::separating:
            return plane.satisfied ? BoxLook::separating : BoxLook::separating_fails;
        default:
            return plane.satisfied ? BoxLook::own : BoxLook::own_fails;
    }
}

}  // namespace

PlanePainter::PlanePainter(const Session<2>& session, DrawList& list)
    : session_(session), list_(list), first_(list.styles.size()) {
    const auto& looks = box_looks(session.settings().palette);
    list.styles.insert(list.styles.end(), looks.begin(), looks.end());
}

std::uint16_t PlanePainter::index(BoxLook look) const {
    return static_cast<std::uint16_t>(first_ + static_cast<std::size_t>(look));
}

void PlanePainter::polygon(std::span<const Vec<2>> points, BoxLook look) {
    if (points.size() >= 3) list_.add(ShapeKind::polygon, index(look), points);
}

void PlanePainter::box(const Box<2>& box, BoxLook look) { polygon(box.corners(), look); }

void PlanePainter::boxes() {
    for (const ShownBox<2>& shown : shown_boxes(session_))
        if (shown.state == CellState::enqueued)
            list_.add(ShapeKind::polygon, static_cast<std::uint16_t>(Look::enqueued), shown.box.corners());
        else
            box(shown.box, shown.state == CellState::hidden   ? BoxLook::invisible
                           : shown.state == CellState::unseen ? BoxLook::outside
                                                              : BoxLook::shown);
    if (const auto leaf = session_.traversal().eye_box()) box(*leaf, BoxLook::eye_leaf);
}

void PlanePainter::occluders() {
    const std::vector<OccluderFact> all = session_.traversal().occluders();
    for (const bool actual : {false, true})
        for (const OccluderFact& occluder : all)
            if (occluder.actual == actual)
                for (const std::uint32_t primitive : occluder.primitives) {
                    const Primitive<2>& s = session_.scene().primitives[primitive];
                    list_.add(ShapeKind::polyline, index(actual ? BoxLook::actual : BoxLook::potential), {s[0], s[1]});
                }
}

void PlanePainter::number(const std::vector<Vec<2>>& where, const char* text) {
    const double whole = list_.world.extent().x * list_.world.extent().y;
    const Middle middle = middle_of(where);
    if (!(middle.area > whole / 400)) return;  // no room for it
    const Colours& palette = colours(session_.settings().palette);
    Label label;
    label.at = middle.at;
    label.text = text;
    label.scale = 1.2;
    label.colour = palette.ink;
    label.halo = palette.halo;
    label.yields = true;
    list_.labels.push_back(label);
}

void PlanePainter::planes() {
    const std::vector<TestedPlane<2>> planes = planes_at_hand(session_);
    const Vec<2> eye = session_.culling_view().eye;
    const EyeRegions regions = eye_regions(planes, eye, list_.world);
    polygon(regions.partial, BoxLook::partial_eyes);
    polygon(regions.hidden, BoxLook::hidden_eyes);
    const double far = 4 * list_.world.longest_side();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const auto& [a, b] = planes[i].points;
        const double length = std::sqrt(glm::dot(b - a, b - a));
        if (length == 0) continue;
        const Vec<2> reach = (b - a) * (far / length);
        if (i == session_.selected_plane) list_.add(ShapeKind::polyline, index(BoxLook::lit), {a - reach, a + reach});
        list_.add(ShapeKind::polyline, index(plane_look(planes[i])), {a - reach, a + reach});
    }
    number(regions.hidden, "3");
    for (const auto& part : regions.parts_2) number(part, "2");
    for (const auto& part : regions.parts_1) number(part, "1");
    if (const auto region = region_at_hand(session_)) {
        for (const auto& outline : region->outlines) {
            std::vector<Vec<2>> closed = outline;
            closed.push_back(outline.front());
            list_.add(ShapeKind::polyline, index(BoxLook::region), closed);
        }
        const auto corners = region->box.corners();
        list_.add(ShapeKind::polyline, index(BoxLook::region_box),
                  {corners[0], corners[1], corners[2], corners[3], corners[0]});
    }
}

void PlanePainter::outlines() {
    if (const auto last = last_box(session_)) box(*last, BoxLook::last);
    if (const auto at_hand = explained_box(session_)) box(*at_hand, BoxLook::selected);
}

}  // namespace sightline
