// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/counters.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/measure/metrics.h"
#include "core/session/headline.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

std::string share_text(std::optional<double> share) { return share ? short_number(*share) : "none"; }
std::string percent(std::optional<double> share) { return share ? short_number(100 * *share) + " %" : "none"; }

/// Of the text of the window: all of them fit one line of a picture 900 pixels wide.
constexpr float text_share = 0.92f;

ImFont* font_of(const Ui& ui, const Counter& counter) { return counter.bold ? ui.fonts.bold : ui.fonts.text; }

float width_of(const Ui& ui, const Counter& counter) {
    ImFont* const font = font_of(ui, counter);
    const auto width = [&](const std::string& text) {
        return font->CalcTextSizeA(text_share * font->FontSize / ui.framebuffer, 1e9f, 0, text.c_str()).x;
    };
    return std::max(width(counter.text), width(counter.widest));
}

float line_height(const Ui& ui) { return ui.fonts.text->FontSize / ui.framebuffer * 1.3f; }

/// The upper left corner of each, from that of the area; the height last.
std::vector<ImVec2> places(const Ui& ui, const std::vector<Counter>& counters, float width) {
    const float pad = 6 * ui.unit, gap = 12 * ui.unit, line = line_height(ui);
    std::vector<ImVec2> at;
    float x = pad, y = 0;
    for (const Counter& counter : counters) {
        const float w = width_of(ui, counter);
        if (x > pad && x + w > width - pad) {
            x = pad;
            y += line;
        }
        at.push_back({x, y});
        x += w + gap;
    }
    at.push_back({0, y + line});
    return at;
}

}  // namespace

std::vector<Counter> counters(const Session<3>& session, const std::string& title, double draw_ms,
                              std::optional<double> speed) {
    const auto as_wide = [](std::size_t most, const std::string& unit) {
        return std::string(std::to_string(most).size(), '8') + unit;
    };
    std::vector<Counter> all{{title, "", true}};
    all.push_back(
        {counted(session.counters().drawn(), "triangle"), as_wide(session.scene().primitives.size(), " triangles")});
    const Kind pops = session.method().pops;
    const std::string what = session.method().orders_cells() ? "cell"
                             : pops == Kind::object          ? "object"
                             : pops == Kind::node            ? "box"
                                                             : "batch";
    all.push_back({counted(session.traversal().steps(), what),
                   as_wide(session.cells().cell_count(), " " + counted(2, what).substr(2))});
    const bool measured = !session.flying() || session.has_reference();
    const std::string later = "…";
    if (tells_truth(session))
        all.push_back(
            {"coverage " + (measured ? share_text(coverage(session.reference(), session.visible_rendered())) : later),
             "coverage 0.888"});
    if (tells_truth(session))
        all.push_back({"wrong pixels " + (measured ? percent(session.wrong_pixels()) : later), "wrong pixels 88.8 %"});
    // A frame that is stepped through was recorded on the way, which takes longer than flying.
    const std::string how = session.flying() ? "" : " recorded";
    all.push_back({"traversal " + milliseconds_text(session.times().traverse) + how, "traversal 88.8 ms" + how});
    all.push_back({"drawing " + milliseconds_text(draw_ms), "drawing 88.8 ms"});
    if (speed) all.push_back({"speed " + short_number(*speed), "speed 888.8"});
    if (!measured && tells_truth(session)) all.push_back({"… measured when the eye stops"});
    return all;
}

float counters_height(const Ui& ui, const std::vector<Counter>& counters, float width) {
    return places(ui, counters, width).back().y;
}

void draw_counters(ImDrawList& list, const Ui& ui, const std::vector<Counter>& counters, const Area& area) {
    const std::vector<ImVec2> at = places(ui, counters, area.w);
    for (std::size_t i = 0; i < counters.size(); ++i) {
        ImFont* const font = font_of(ui, counters[i]);
        list.AddText(font, text_share * font->FontSize / ui.framebuffer, {area.x + at[i].x, area.y + at[i].y},
                     colour(theme::ink), counters[i].text.c_str());
    }
}

}  // namespace sightline
