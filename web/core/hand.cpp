// Fingers and the mouse on the picture in the plane: as the window takes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.h"
#include "core/draw/picking_3d.h"
#include "core/draw/picture_3d.h"
#include "core/draw/segment_near.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_world.h"
#include "core/session/explain.h"
#include "core/session/explain_primitive.h"
#include "core/session/headline.h"
#include "shell/desk/change.h"
#include "shell/desk/conceal.h"
#include "shell/desk/edit.h"
#include "shell/desk/moves.h"
#include "shell/desk/zoom.h"
#include "web/core/json_text.h"
#include "web/core/picture.h"

namespace sightline {

namespace {

/// What may be selected at a point.
struct Under {
    std::uint32_t cell = none, node = none, primitive = none;
};

Under under(const Session<2>& session, const Vec<2>& at, double reach) {
    Under found;
    if (walks_boxes(session))
        found.node = box_near(session, at, reach);
    else
        found.cell = locate(session.cells(), at);
    found.primitive = segment_near(session.scene().primitives, at, reach);
    return found;
}

std::vector<std::string> choices_of(const Under& found) {
    std::vector<std::string> here;
    if (found.primitive != none) here.push_back("primitive:" + std::to_string(found.primitive));
    if (found.node != none) here.push_back("node:" + std::to_string(found.node));
    if (found.cell != none) here.push_back(std::to_string(found.cell));
    return here;
}

/// The end of a segment within reach.
std::optional<std::size_t> end_near(const Session<2>& session, std::uint32_t segment, const Vec<2>& at, double reach) {
    const Primitive<2>& ends = session.scene().primitives[segment];
    const double first = glm::length(ends[0] - at), second = glm::length(ends[1] - at);
    if (std::min(first, second) > reach) return std::nullopt;
    return first <= second ? 0 : 1;
}

/// Where an end goes: to that of another wall within reach.
Vec<2> snapped(const Session<2>& session, const Hand& hand, const Vec<2>& to) {
    Vec<2> nearest = to;
    double least = hand.reach;
    const std::vector<Primitive<2>>& walls = session.scene().primitives;
    for (std::uint32_t i = 0; i < walls.size(); ++i)
        for (const Vec<2>& end : walls[i])
            if (const double away = glm::length(end - to); i != hand.wall && away < least) {
                least = away;
                nearest = end;
            }
    return nearest;
}

void drag_wall(Workbench<2>& bench, const Hand& hand, const Vec<2>& to) {
    Primitive<2> wall = hand.before.session.scene().primitives[hand.wall];
    if (hand.end)
        wall[*hand.end] = snapped(bench.session, hand, to);
    else
        for (Vec<2>& end : wall) end += to - hand.from;
    if (wall != bench.session.scene().primitives[hand.wall]) move_segment(bench, hand.wall, wall, "drag");
    bench.session.selected_primitive = hand.wall;
    hold(bench, hand.world, "drag");
}

bool eye_within(const Session<2>& session, const Vec<2>& at, double reach) {
    return glm::length(session.display_view().eye - at) <= reach;
}

}  // namespace

std::string under_json(Page& page, const Vec<2>& at, double reach) {
    if (!page.plane) return "{}";
    const Workbench<2>& bench = page.plane->bench;
    const Under found = under(bench.session, at, reach);
    JsonText json;
    json.object();
    if (found.cell != none) json.member("cell", found.cell);
    if (found.primitive != none) json.member("primitive", found.primitive);
    json.member("eye", eye_within(bench.session, at, 2 * reach));
    std::string words;
    if (found.cell != none)
        words = conceal(bench, "cell " + std::to_string(found.cell) + ": " + place_words(bench.session, found.cell));
    if (found.primitive != none)
        words = primitive_name(bench.session.scene(), found.primitive) + (words.empty() ? "" : ", ") + words;
    json.member("words", words);
    if (bench.desk.edit && found.primitive != none)
        json.member("drag", end_near(bench.session, found.primitive, at, reach) ? "drag: move this end"
                                                                                : "drag: move the wall");
    return json.end_object().take();
}

namespace {

/// What a tap in space can take: the nearest cell that is drawn, and the nearest triangle. One that is selected already
/// makes room for the other.
void tap_space(Page& page, const Vec<2>& at) {
    BenchOnPage<3>& on = *page.space;
    const Session<3>& session = on.bench.session;
    if (session.flying()) return;
    auto options = on.sides.options<PictureOptions3>(0);
    const Vec<2> size = page.papers[0].world.extent();
    options.aspect = size.x / size.y;
    const Pick3d found = pick(make_solid(session, options), at);
    std::vector<std::string> here;
    if (found.cell != none && session.selected_cell != found.cell) here.push_back(std::to_string(found.cell));
    if (found.primitive != none && !asks_for_cell(on.bench) && session.selected_primitive != found.primitive)
        here.push_back("primitive:" + std::to_string(found.primitive));
    run_on_page(page, "select " + (here.empty() ? "none" : here.front()));
}

}  // namespace

void tap(Page& page, const Vec<2>& at, double reach) {
    if (!page.plane) return tap_space(page, at);
    const Workbench<2>& bench = page.plane->bench;
    Under found = under(bench.session, at, reach);
    if (asks_for_cell(bench) && found.cell != none) found.primitive = none;
    const std::vector<std::string> here = choices_of(found);
    if (here.empty()) return run_on_page(page, "select none");
    // A tap on what is selected goes on to what lies under it.
    const Session<2>& s = bench.session;
    std::size_t at_hand = here.size();
    for (std::size_t i = 0; i < here.size(); ++i)
        if ((here[i].starts_with("primitive:") && s.selected_primitive == found.primitive) ||
            (here[i].starts_with("node:") && s.selected_node == found.node) ||
            (here[i] == std::to_string(found.cell) && s.selected_cell == found.cell && s.selected_primitive == none))
            at_hand = i;
    run_on_page(page, "select " + here[at_hand < here.size() ? (at_hand + 1) % here.size() : 0]);
}

void tap_twice(Page& page, const Vec<2>& at) {
    if (!page.plane) return;
    const std::uint32_t cell = locate(page.plane->bench.session.cells(), at);
    if (cell == none || walks_boxes(page.plane->bench.session)) return;
    run_on_page(page, "select " + std::to_string(cell) + "; reach " + std::to_string(cell));
}

Held take(Page& page, const Vec<2>& at, double reach) {
    if (!page.plane) return Held::picture;
    Workbench<2>& bench = page.plane->bench;
    Hand hand{begin_gesture(bench), at, shown_world(bench.session)};
    hand.reach = reach;
    if (eye_within(bench.session, at, reach)) {
        hand.held = Held::eye;
    } else if (bench.desk.edit) {
        hand.wall = segment_near(bench.session.scene().primitives, at, reach);
        if (hand.wall != none) {
            hand.held = Held::wall;
            hand.end = end_near(bench.session, hand.wall, at, reach);
        }
    }
    return page.hand.emplace(std::move(hand)).held;
}

void drag(Page& page, const Vec<2>& to) {
    if (!page.plane || !page.hand) return;
    Workbench<2>& bench = page.plane->bench;
    const Hand& hand = *page.hand;
    ++page.revision;
    if (hand.held == Held::picture) {
        centre_on(bench, hand.world.centre() + hand.from - to, "drag");
        page.hand->world = shown_world(bench.session);
        return;
    }
    ViewSpec<2> view = hand.before.session.display_view();
    view.eye += to - hand.from;
    view.look_at += to - hand.from;
    try {
        if (hand.held == Held::wall)
            drag_wall(bench, hand, to);
        else if (view != bench.session.display_view())
            change_view(bench, view, "drag");
    } catch (const InputError&) {
        return;  // the last good place stays
    }
    const std::uint32_t step = hand.before.session.position();  // a shorter run on the way must not lose it
    if (bench.session.position() != step) go_to_step(bench, step);
}

void let_go(Page& page, bool back) {
    if (!page.plane || !page.hand) return;
    Workbench<2>& bench = page.plane->bench;
    if (back)
        cancel_gesture(bench, std::move(page.hand->before));
    else
        bench.history.gesture.clear();
    page.hand.reset();
    ++page.revision;
}

void magnify(Page& page, const Vec<2>& fixed, double factor) {
    if (!page.plane || !(factor > 0)) return;
    zoom_about(page.plane->bench, fixed, factor, "zoom");
    ++page.revision;
}

}  // namespace sightline
