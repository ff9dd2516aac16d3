// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/look.h"

#include <cmath>

#include "core/base/error.h"
#include "core/draw/key_light.h"
#include "core/draw/variant_look.h"
#include "core/methods/formula/formula_heuristic.h"
#include "core/session/headline.h"
#include "core/session/lanes.h"
#include "core/session/settings_table.h"
#include "shell/commands/teach.h"
#include "shell/desk/compare.h"
#include "shell/desk/conceal.h"
#include "shell/desk/into.h"
#include "shell/desk/play.h"
#include "shell/panels/panel_table.h"
#include "web/core/json_text.h"

namespace sightline {

namespace {

constexpr auto tone_words =
    std::to_array<std::string_view>({"plain", "heading", "faint", "good", "bad", "lit", "link"});

void put_row(JsonText& json, const Row& row) {
    json.object().member("text", row.text).member("tone", tone_words[static_cast<std::size_t>(row.tone)]);
    if (!row.command.empty()) json.member("command", row.command);
    if (row.cell != none) json.member("cell", row.cell);
    if (row.indent > 0) json.member("indent", row.indent);
    if (!row.tip.empty()) json.member("tip", row.tip);
    if (row.captions) json.member("captions", true);
    if (!row.parts.empty()) {
        json.name("parts").array();
        for (const KeyPart& part : row.parts) {
            json.object().member("text", part.text);
            if (part.about != KeyAbout::nothing)
                json.member("about", static_cast<int>(part.about)).member("name", part.name);
            json.end_object();
        }
        json.end_array().name("light").values(std::array{row.light.from, row.light.facet, row.light.cell});
    }
    json.end_object();
}

void put_rows(JsonText& json, const std::vector<Row>& rows) {
    json.array();
    for (const Row& row : rows) put_row(json, row);
    json.end_array();
}

template <int D>
void put_panel(JsonText& json, const Workbench<D>& bench, const std::string& id) {
    const Panel<D>* const panel = find_panel<D>(id);
    if (!panel) throw InputError("there is no panel '" + id + "'");
    put_rows(json, panel_rows(*panel, bench));
}

void put_desk(JsonText& json, const Desk& desk) {
    json.object()
        .member("projector", desk.projector)
        .member("blank", desk.blank)
        .member("speaker", desk.speaker)
        .member("edit", desk.edit)
        .member("tool", tool_words[static_cast<std::size_t>(desk.tool)])
        .member("left", desk.left)
        .member("right", desk.right)
        .member("timeline", desk.timeline)
        .member("legend", desk.legend)
        .member("animate", desk.animate)
        .member("fullscreen", desk.fullscreen)
        .end_object();
}

/// One run, or both with their names.
template <int D>
std::string results(const Workbench<D>& bench, const Session<D>& shown) {
    if (!bench.other) return result_line(shown);
    const auto titles = side_titles(bench);
    return titles[0] + ": " + result_line(shown) + "; " + titles[1] + ": " + result_line(bench.other->session);
}

/// "step 7 of 16", or the sentence of the step.
template <int D>
std::string step_words(const Workbench<D>& bench, const Session<D>& shown) {
    if (bench.session.flying() || bench.session.position() == 0)
        return "step 0 of " + std::to_string(bench.session.recorded());
    const std::vector<Row> step{{step_line(explain_step(shown, shown.position()), tells_truth(shown))}};
    return conceal_rows(bench, step).at(0).text;
}

template <int D>
std::string look(Page& page, Workbench<D>& bench) {
    const Session<D>& session = bench.session;
    const ShownSession<D> shown(bench);
    JsonText json;
    json.object()
        .member("dimension", D)
        .member("scene", session.scene().name.empty() ? session.scene().id : session.scene().name)
        .member("source", session.scene().source)
        .member("title", session.scene().title)
        .member("headline", headline(session))
        .member("position", session.position())
        .member("recorded", session.recorded())
        .member("run", bench.run)
        .member("method", session.settings().method)
        .member("guarantee", session.guarantee())
        .member("state", transport_words[static_cast<std::size_t>(transport_state(bench))])
        .member("frozen", session.frozen())
        .member("selected", session.selected_cell == none ? -1 : static_cast<std::int64_t>(session.selected_cell))
        .member("asks", asks_for_cell(bench))
        .member("undo", !bench.history.past.empty())
        .member("redo", !bench.history.future.empty())
        .member("panes", bench.other ? 2 : 1);
    json.name("eye").values(std::array{session.display_view().eye.x, session.display_view().eye.y});
    if constexpr (D == 3) json.member("flight", bench.flight.on);
    if (session.method().id == "formula") json.member("formula", session.settings().parameters.text(formula_key_row()));
    if (!session.flying()) json.member("result", results(bench, *shown));
    json.member("step", step_words(bench, *shown));
    put_desk(json.name("desk"), bench.desk);
    put_rows(json.name("lesson"), lesson_lines(bench));
    if (bench.teaching)
        json.name("teaching")
            .object()
            .member("id", bench.teaching->lesson.id)
            .member("part", bench.teaching->part)
            .member("asksKey", bench.teaching->next() && bench.teaching->next()->key_of.has_value())
            .end_object();
    if (bench.desk.speaker) put_rows(json.name("speaker"), speaker_rows(bench));
    if (find_panel<D>(bench.desk.right)) put_panel(json.name("panel"), bench, bench.desk.right);
    if (!page.said.empty()) {
        json.name("said").array();
        for (const Said& said : page.said) json.object().member("text", said.text).member("bad", said.bad).end_object();
        json.end_array();
        page.said.clear();
    }
    return json.end_object().take();
}

/// Four digits behind the point are finer than any screen.
void put_rounded(JsonText& json, const std::vector<double>& values) {
    json.array();
    for (const double value : values) json.value(std::round(value * 1e4) / 1e4);
    json.end_array();
}

}  // namespace

std::string look_json(Page& page) {
    return with_bench(page, [&](auto& on) { return look(page, on.bench); });
}

std::string panel_json(Page& page, const std::string& id) {
    return with_bench(page, [&](auto& on) {
        JsonText json;
        put_panel(json, on.bench, id);
        return json.take();
    });
}

std::string settings_json(Page& page) {
    return with_bench(page, [&]<int D>(BenchOnPage<D>& on) {
        const Session<D>& session = on.bench.session;
        static constexpr std::array groups{"picture", "reference", "traversal", "tessellation", "scene"};
        JsonText json;
        json.array();
        for (const SettingRow& row : settings_table()) {
            if (!applies<D>(row, session.method())) continue;
            json.object()
                .member("name", row.name)
                .member("help", row.help)
                .member("source", row.source)
                .member("values", row.values)
                .member("group", groups[static_cast<std::size_t>(row.invalidates)])
                .member("value", row.get(session.settings()))
                .member("otherwise", row.get({}))
                .member("parameter", row.parameter != nullptr);
            if (row.name == "method") {
                json.name("words").array();
                for (const Method<D>& method : on.bench.methods) json.value(method.id);
                json.end_array();
            } else if (!row.words.empty()) {
                json.name("words").values(row.words);
            }
            json.end_object();
        }
        return json.end_array().take();
    });
}

std::string curve_json(Page& page) {
    return with_bench(page, [&]<int D>(BenchOnPage<D>& on) {
        const Session<D>& session = on.bench.session;
        if (session.flying()) return std::string("{}");
        const Lanes lanes = make_lanes(session);
        JsonText json;
        json.object().member("run", on.bench.run).member("tells", tells_truth(session));
        put_rounded(json.name("coverage"), lanes.coverage);
        put_rounded(json.name("oracle"), lanes.oracle);
        json.name("hidden").values(lanes.hidden).name("visible").values(lanes.visible);
        put_rounded(json.name("key"), lanes.key);
        json.name("cell").array();
        for (const std::uint32_t cell : lanes.cell) json.value(cell == none ? -1 : static_cast<std::int64_t>(cell));
        json.end_array();
        if (on.bench.other) put_rounded(json.name("other"), make_lanes(on.bench.other->session).coverage);
        json.name("bookmarks").array();
        for (const Bookmark& mark : session.bookmarks)
            json.object().member("step", mark.step).member("label", mark.label).end_object();
        return json.end_array().end_object().take();
    });
}

std::string light_json(Page& page, int about, std::uint32_t from, std::uint32_t facet, std::uint32_t cell) {
    JsonText json;
    json.array();
    if (page.plane)
        for (const LightLine<2>& line :
             key_light(page.plane->bench.session, KeyLight{static_cast<KeyAbout>(about), from, facet, cell})) {
            json.object().name("points").array();
            for (const Vec<2>& p : line.points) json.values(std::array{p.x, p.y});
            json.end_array().member("closed", line.closed).member("arrow", line.arrow).end_object();
        }
    return json.end_array().take();
}

std::string corners_json(Page& page, std::uint32_t cell) {
    JsonText json;
    json.array();
    if (page.plane) {
        const CellComplex<2>& cells = page.plane->bench.session.cells();
        if (cell < cells.cell_count())
            for (const std::uint32_t p : cells.corners_of(cell))
                json.values(std::array{cells.points[p].x, cells.points[p].y});
    }
    return json.end_array().take();
}

}  // namespace sightline
