// Fingers and the mouse on the picture in the plane: as the window takes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/draw/segment_near.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_world.h"
#include "core/session/explain.h"
#include "core/session/explain_primitive.h"
#include "core/session/headline.h"
#include "shell/desk/change.h"
#include "shell/desk/conceal.h"
#include "shell/desk/moves.h"
#include "shell/desk/zoom.h"
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

bool eye_within(const Session<2>& session, const Vec<2>& at, double reach) {
    return glm::length(session.display_view().eye - at) <= reach;
}

}  // namespace

std::string under_json(Page& page, const Vec<2>& at, double reach) {
    nlohmann::ordered_json json;
    if (!page.plane) return "{}";
    const Workbench<2>& bench = page.plane->bench;
    const Under found = under(bench.session, at, reach);
    if (found.cell != none) json["cell"] = found.cell;
    if (found.primitive != none) json["primitive"] = found.primitive;
    json["eye"] = eye_within(bench.session, at, 2 * reach);
    std::string words;
    if (found.cell != none)
        words = conceal(bench, "cell " + std::to_string(found.cell) + ": " + place_words(bench.session, found.cell));
    if (found.primitive != none)
        words = primitive_name(bench.session.scene(), found.primitive) + (words.empty() ? "" : ", ") + words;
    json["words"] = words;
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void tap(Page& page, const Vec<2>& at, double reach) {
    if (!page.plane) return;
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

bool take(Page& page, const Vec<2>& at, double reach) {
    if (!page.plane) return false;
    Workbench<2>& bench = page.plane->bench;
    const bool eye = eye_within(bench.session, at, reach);
    page.hand.emplace(Hand{begin_gesture(bench), at, shown_world(bench.session), eye});
    return eye;
}

void drag(Page& page, const Vec<2>& to) {
    if (!page.plane || !page.hand) return;
    Workbench<2>& bench = page.plane->bench;
    const Hand& hand = *page.hand;
    ++page.revision;
    if (!hand.eye) {
        centre_on(bench, hand.world.centre() + hand.from - to, "drag");
        page.hand->world = shown_world(bench.session);
        return;
    }
    ViewSpec<2> view = hand.before.session.display_view();
    view.eye += to - hand.from;
    view.look_at += to - hand.from;
    try {
        if (view != bench.session.display_view()) change_view(bench, view, "drag");
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
