// The functions that diagrams of the article call, in C: each on a page of its own, all in one memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <emscripten/emscripten.h>

#include <nlohmann/json.hpp>

#include "web/core/article.h"

namespace {

using namespace sightline;

/// As answer() of exports.cpp: what `f` makes, or {"error": …}.
template <typename F>
const char* replied(Page* page, F f) {
    try {
        page->reply = f();
    } catch (const std::exception& error) {
        page->reply =
            nlohmann::json{{"error", error.what()}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    }
    return page->reply.c_str();
}

}  // namespace

extern "C" {

/// Ends a page: a diagram that is far away keeps its state as text and gives its memory back.
EMSCRIPTEN_KEEPALIVE void page_free(Page* page) { delete page; }

EMSCRIPTEN_KEEPALIVE const char* page_numbers(Page* page, const char* asked) {
    return replied(page, [&] { return numbers_json(*page, asked); });
}
EMSCRIPTEN_KEEPALIVE const char* page_place(Page* page, const char* name) {
    return replied(page, [&] { return place_json(*page, name); });
}
EMSCRIPTEN_KEEPALIVE const char* page_names(Page* page, double x, double y, double reach) {
    return replied(page, [&] { return names_json(*page, {x, y}, reach); });
}
EMSCRIPTEN_KEEPALIVE const char* page_crossed(Page* page, int columns) {
    return replied(page, [&] { return crossed_json(*page, columns); });
}
EMSCRIPTEN_KEEPALIVE const char* page_dots(Page* page) {
    return replied(page, [&] { return dots_json(*page); });
}
EMSCRIPTEN_KEEPALIVE int page_work_out(Page* page, double milliseconds) {
    try {
        return work_out(*page, milliseconds);
    } catch (const std::exception& error) {
        page->said.push_back({error.what(), true});
        return 0;
    }
}
EMSCRIPTEN_KEEPALIVE void page_forget(Page* page) { forget_past(*page); }

}  // extern "C"
