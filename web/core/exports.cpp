// The functions that the page calls, in C. Texts that come back belong to the page and last until the next call.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <emscripten/emscripten.h>

#include <nlohmann/json.hpp>

#include "web/core/look.h"
#include "web/core/picture.h"
#include "web/core/self_test.h"

namespace {

using namespace sightline;

/// What `f` makes, or what went wrong as {"error": …}: nothing may leave this file but a return.
template <typename F>
const char* answer(Page* page, F f) {
    try {
        page->reply = f();
    } catch (const std::bad_alloc&) {
        page->reply = R"({"error":"this needs more memory than a page gets"})";
    } catch (const std::exception& error) {
        page->reply =
            nlohmann::json{{"error", error.what()}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    }
    return page->reply.c_str();
}

template <typename F>
const char* does(Page* page, F f) {
    return answer(page, [&] {
        f();
        return std::string("{}");
    });
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE Page* page_new() { return new Page; }

/// Empty where the exact predicates are exact.
EMSCRIPTEN_KEEPALIVE const char* page_self_test(Page* page, unsigned inputs) {
    return answer(page, [&] { return predicates_fail(inputs); });
}

/// Widths in em of the characters 0 to 127, then of any other one.
EMSCRIPTEN_KEEPALIVE void page_font(Page* page, const float* widths) {
    std::copy(widths, widths + 128, page->font.ascii.begin());
    page->font.other = widths[128];
}

EMSCRIPTEN_KEEPALIVE const char* page_open(Page* page, const char* name) {
    return does(page, [&] { open_on_page(*page, name); });
}
EMSCRIPTEN_KEEPALIVE const char* page_open_state(Page* page, const char* text) {
    return does(page, [&] { open_state_on_page(*page, text); });
}
EMSCRIPTEN_KEEPALIVE const char* page_state(Page* page) {
    return answer(page, [&] { return state_of_page(*page); });
}
EMSCRIPTEN_KEEPALIVE const char* page_handout(Page* page) {
    return answer(page, [&] { return handout_of_page(*page); });
}
EMSCRIPTEN_KEEPALIVE const char* page_do(Page* page, const char* commands) {
    return does(page, [&] { run_on_page(*page, commands); });
}
EMSCRIPTEN_KEEPALIVE int page_tick(Page* page, double seconds) {
    try {
        return tick(*page, seconds);
    } catch (const std::exception& error) {
        page->said.push_back({error.what(), true});
        return 1;
    }
}

EMSCRIPTEN_KEEPALIVE int page_idle(Page* page, double milliseconds) {
    try {
        return idle(*page, milliseconds);
    } catch (const std::exception& error) {
        page->said.push_back({error.what(), true});
        return 1;
    }
}

EMSCRIPTEN_KEEPALIVE const char* page_look(Page* page) {
    return answer(page, [&] { return look_json(*page); });
}
EMSCRIPTEN_KEEPALIVE const char* page_panel(Page* page, const char* id) {
    return answer(page, [&] { return panel_json(*page, id); });
}
EMSCRIPTEN_KEEPALIVE const char* page_settings(Page* page) {
    return answer(page, [&] { return settings_json(*page); });
}
EMSCRIPTEN_KEEPALIVE const char* page_tables(Page* page) {
    return answer(page, [&] { return tables_json(*page); });
}
EMSCRIPTEN_KEEPALIVE const char* page_scenes(Page* page) { return answer(page, scenes_json); }
EMSCRIPTEN_KEEPALIVE const char* page_curve(Page* page) {
    return answer(page, [&] { return curve_json(*page); });
}
EMSCRIPTEN_KEEPALIVE const char* page_light(Page* page, int about, unsigned from, unsigned facet, unsigned cell) {
    return answer(page, [&] { return light_json(*page, about, from, facet, cell); });
}
EMSCRIPTEN_KEEPALIVE const char* page_corners(Page* page, unsigned cell) {
    return answer(page, [&] { return corners_json(*page, cell); });
}
/// The state's hash, as in the list of hashes.
EMSCRIPTEN_KEEPALIVE const char* page_hash(Page* page) {
    return answer(page, [&] { return with_bench(*page, [](auto& on) { return hash_text(on.bench.session.hash()); }); });
}

EMSCRIPTEN_KEEPALIVE const char* page_picture(Page* page, int pane, double width, double height, double unit) {
    return answer(page, [&] { return picture_json(*page, pane, width, height, unit); });
}
EMSCRIPTEN_KEEPALIVE const char* page_under(Page* page, double x, double y, double reach) {
    return answer(page, [&] { return under_json(*page, {x, y}, reach); });
}
EMSCRIPTEN_KEEPALIVE const char* page_tap(Page* page, double x, double y, double reach) {
    return does(page, [&] { tap(*page, {x, y}, reach); });
}
EMSCRIPTEN_KEEPALIVE const char* page_tap_twice(Page* page, double x, double y) {
    return does(page, [&] { tap_twice(*page, {x, y}); });
}
/// 0: of the picture, 1: of the eye, 2: of a wall.
EMSCRIPTEN_KEEPALIVE int page_take(Page* page, double x, double y, double reach) {
    return static_cast<int>(take(*page, {x, y}, reach));
}
/// The eye of a flight: seconds to its right, up and ahead at the flight's speed; degrees to the right and up.
EMSCRIPTEN_KEEPALIVE const char* page_fly(Page* page, double right, double up, double ahead, double turn, double rise) {
    return does(page, [&] { fly_on_page(*page, {right, up, ahead}, {turn, rise}); });
}
EMSCRIPTEN_KEEPALIVE const char* page_trade_off(Page* page) {
    return answer(page, [&] { return trade_off_json(*page); });
}
EMSCRIPTEN_KEEPALIVE const char* page_drag(Page* page, double x, double y) {
    return does(page, [&] { drag(*page, {x, y}); });
}
EMSCRIPTEN_KEEPALIVE const char* page_let_go(Page* page, int back) {
    return does(page, [&] { let_go(*page, back != 0); });
}
EMSCRIPTEN_KEEPALIVE const char* page_magnify(Page* page, double x, double y, double factor) {
    return does(page, [&] { magnify(*page, {x, y}, factor); });
}

}  // extern "C"
