// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/look.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/draw/key_light.h"
#include "core/draw/variant_look.h"
#include "core/session/headline.h"
#include "core/session/lanes.h"
#include "core/session/settings_table.h"
#include "shell/commands/teach.h"
#include "shell/desk/compare.h"
#include "shell/desk/conceal.h"
#include "shell/desk/into.h"
#include "shell/desk/play.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

using Json = nlohmann::ordered_json;

constexpr auto tone_words =
    std::to_array<std::string_view>({"plain", "heading", "faint", "good", "bad", "lit", "link"});

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json row_json(const Row& row) {
    Json json{{"text", row.text}, {"tone", tone_words[static_cast<std::size_t>(row.tone)]}};
    if (!row.command.empty()) json["command"] = row.command;
    if (row.cell != none) json["cell"] = row.cell;
    if (row.indent > 0) json["indent"] = row.indent;
    if (!row.tip.empty()) json["tip"] = row.tip;
    if (row.captions) json["captions"] = true;
    for (const KeyPart& part : row.parts) {
        Json one{{"text", part.text}};
        if (part.about != KeyAbout::nothing) {
            one["about"] = static_cast<int>(part.about);
            one["name"] = part.name;
        }
        json["parts"].push_back(std::move(one));
    }
    if (!row.parts.empty()) json["light"] = {row.light.from, row.light.facet, row.light.cell};
    return json;
}

Json rows_json(const std::vector<Row>& rows) {
    Json json = Json::array();
    for (const Row& row : rows) json.push_back(row_json(row));
    return json;
}

template <int D>
Json panel_rows_json(const Workbench<D>& bench, const std::string& id) {
    const Panel<D>* const panel = find_panel<D>(id);
    if (!panel) throw InputError("there is no panel '" + id + "'");
    return rows_json(panel_rows(*panel, bench));
}

Json desk_json(const Desk& desk) {
    return {{"projector", desk.projector},
            {"scale", desk.scale},
            {"blank", desk.blank},
            {"speaker", desk.speaker},
            {"edit", desk.edit},
            {"chooser", desk.chooser},
            {"lessons", desk.lessons},
            {"help", desk.help},
            {"console", desk.console},
            {"consoleText", desk.console_text},
            {"tool", tool_words[static_cast<std::size_t>(desk.tool)]},
            {"left", desk.left},
            {"right", desk.right},
            {"timeline", desk.timeline},
            {"legend", desk.legend},
            {"animate", desk.animate},
            {"fullscreen", desk.fullscreen}};
}

/// One run, or both with their names.
template <int D>
std::string results(const Workbench<D>& bench, const Session<D>& shown) {
    if (!bench.other) return result_line(shown);
    const auto titles = side_titles(bench);
    return titles[0] + ": " + result_line(shown) + "; " + titles[1] + ": " + result_line(bench.other->session);
}

template <int D>
Json look(Page& page, Workbench<D>& bench) {
    const Session<D>& session = bench.session;
    const ShownSession<D> shown(bench);
    Json json{{"dimension", D},
              {"scene", session.scene().name.empty() ? session.scene().id : session.scene().name},
              {"source", session.scene().source},
              {"title", session.scene().title},
              {"headline", headline(session)},
              {"position", session.position()},
              {"recorded", session.recorded()},
              {"run", bench.run},
              {"method", session.settings().method},
              {"guarantee", session.guarantee()},
              {"state", transport_words[static_cast<std::size_t>(transport_state(bench))]},
              {"frozen", session.frozen()},
              {"selected", session.selected_cell == none ? -1 : static_cast<std::int64_t>(session.selected_cell)},
              {"asks", asks_for_cell(bench)},
              {"undo", !bench.history.past.empty()},
              {"redo", !bench.history.future.empty()},
              {"panes", bench.other ? 2 : 1},
              {"eye", {session.display_view().eye.x, session.display_view().eye.y}}};
    if (!session.flying()) json["result"] = results(bench, *shown);
    std::vector<Row> step;
    if (!session.flying() && session.position() > 0)
        step.push_back({step_line(explain_step(*shown, shown->position()), tells_truth(*shown))});
    else
        step.push_back({"step 0 of " + std::to_string(session.recorded())});
    json["step"] = rows_json(conceal_rows(bench, std::move(step)))[0]["text"];
    json["desk"] = desk_json(bench.desk);
    json["lesson"] = rows_json(lesson_lines(bench));
    if (bench.teaching)
        json["teaching"] = {{"id", bench.teaching->lesson.id},
                            {"part", bench.teaching->part},
                            {"asksKey", bench.teaching->next() && bench.teaching->next()->key_of.has_value()}};
    if (bench.desk.speaker) json["speaker"] = rows_json(speaker_rows(bench));
    if (find_panel<D>(bench.desk.right)) json["panel"] = panel_rows_json(bench, bench.desk.right);
    for (const Said& said : page.said) json["said"].push_back({{"text", said.text}, {"bad", said.bad}});
    page.said.clear();
    return json;
}

Json finite(const std::vector<double>& values) {
    Json json = Json::array();
    for (const double value : values)
        json.push_back(std::isfinite(value) ? Json(std::round(value * 1e4) / 1e4) : Json());
    return json;
}

}  // namespace

std::string look_json(Page& page) {
    return with_bench(page, [&](auto& on) { return text_of(look(page, on.bench)); });
}

std::string panel_json(Page& page, const std::string& id) {
    return with_bench(page, [&](auto& on) { return text_of(panel_rows_json(on.bench, id)); });
}

std::string settings_json(Page& page) {
    return with_bench(page, [&]<int D>(BenchOnPage<D>& on) {
        const Session<D>& session = on.bench.session;
        static constexpr std::array groups{"picture", "reference", "traversal", "tessellation", "scene"};
        Json json = Json::array();
        for (const SettingRow& row : settings_table()) {
            if (!applies<D>(row, session.method())) continue;
            Json one{{"name", row.name},
                     {"help", row.help},
                     {"source", row.source},
                     {"values", row.values},
                     {"group", groups[static_cast<std::size_t>(row.invalidates)]},
                     {"value", row.get(session.settings())},
                     {"otherwise", row.get({})},
                     {"parameter", row.parameter != nullptr}};
            for (const std::string_view word : row.words) one["words"].push_back(word);
            if (row.name == "method")
                for (const Method<D>& method : on.bench.methods) one["words"].push_back(method.id);
            json.push_back(std::move(one));
        }
        return text_of(json);
    });
}

std::string curve_json(Page& page) {
    return with_bench(page, [&]<int D>(BenchOnPage<D>& on) {
        const Session<D>& session = on.bench.session;
        if (session.flying()) return std::string("{}");
        const Lanes lanes = make_lanes(session);
        Json json{{"run", on.bench.run}, {"tells", tells_truth(session)}};
        json["coverage"] = finite(lanes.coverage);
        json["oracle"] = finite(lanes.oracle);
        json["hidden"] = lanes.hidden;
        json["visible"] = lanes.visible;
        for (const std::uint32_t cell : lanes.cell)
            json["cell"].push_back(cell == none ? -1 : static_cast<std::int64_t>(cell));
        if (on.bench.other) json["other"] = finite(make_lanes(on.bench.other->session).coverage);
        for (const Bookmark& mark : session.bookmarks)
            json["bookmarks"].push_back({{"step", mark.step}, {"label", mark.label}});
        return text_of(json);
    });
}

std::string light_json(Page& page, int about, std::uint32_t from, std::uint32_t facet, std::uint32_t cell) {
    Json json = Json::array();
    if (!page.plane) return text_of(json);
    const KeyLight light{static_cast<KeyAbout>(about), from, facet, cell};
    for (const LightLine<2>& line : key_light(page.plane->bench.session, light)) {
        Json points = Json::array();
        for (const Vec<2>& p : line.points) points.push_back({p.x, p.y});
        json.push_back({{"points", points}, {"closed", line.closed}, {"arrow", line.arrow}});
    }
    return text_of(json);
}

std::string corners_json(Page& page, std::uint32_t cell) {
    Json json = Json::array();
    if (!page.plane) return text_of(json);
    const CellComplex<2>& cells = page.plane->bench.session.cells();
    if (cell < cells.cell_count())
        for (const std::uint32_t p : cells.corners_of(cell)) json.push_back({cells.points[p].x, cells.points[p].y});
    return text_of(json);
}

}  // namespace sightline
