// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/file_kind.h"
#include "core/scene/read/import_mesh.h"
#include "shell/commands/arguments.h"
#include "shell/commands/command_table.h"
#include "shell/desk/camera.h"
#include "shell/desk/faults.h"
#include "shell/desk/fly.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/desk/moved.h"
#include "shell/desk/moves.h"
#include "shell/desk/open.h"
#include "shell/desk/play.h"
#include "shell/desk/what_if.h"
#include "shell/export/export.h"
#include "shell/export/handout.h"

namespace sightline {

namespace {

/// What a person set up beside the scene: a new bench keeps it.
Desk kept_desk(const Page& page) {
    Desk desk;
    if (page.plane) desk = page.plane->bench.desk;
    if (page.space) desk = page.space->bench.desk;
    desk.chooser = desk.lessons = desk.help = desk.console = desk.edit = false;
    return desk;
}

template <int D>
void put(Page& page, Workbench<D> bench) {
    bench.say = [&page](const std::string& line) { page.said.push_back({line}); };
    auto made = std::make_unique<BenchOnPage<D>>(std::move(bench));
    page.plane.reset();
    page.space.reset();
    page.papers = {};
    page.hand.reset();
    ++page.revision;
    if constexpr (D == 2)
        page.plane = std::move(made);
    else
        page.space = std::move(made);
}

/// A bench of the first scene of its dimension, for another to be opened on it.
template <int D>
Workbench<D> bench_of(Page& page, const std::string& name) {
    const auto warn = [&page](const std::string& line) { page.said.push_back({"warning: " + line}); };
    Session<D> session = open_scene<D>(name, start_settings<D>(name, true), method_table<D>(), warn);
    add_bookmarks(session);
    Workbench<D> bench{.session = std::move(session)};
    bench.desk = kept_desk(page);
    bench.record_ahead = true;
    record_whole_run(bench.session);
    bench.run = 1;
    if (D == 3) run_to_end(bench);  // its start shows nothing
    return bench;
}

int dimension_of_state(const std::string& text, const std::string& name) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded() || !json.is_object()) throw input_error(name, "", "this is not a state file");
    return json.contains("view") && json["view"].is_object() && json["view"].contains("eye") &&
                   json["view"]["eye"].size() == 3
               ? 3
               : 2;
}

template <int D>
void open_state(Page& page, const std::string& text, const std::string& name) {
    Workbench<D> bench = bench_of<D>(page, D == 2 ? "bottleneck" : "blocks");
    bench.say = [&page](const std::string& line) { page.said.push_back({line}); };
    open_handout(bench, text, name);
    put(page, std::move(bench));
}

bool is_3d(const std::string& name) {
    if (find_in_catalogue<2>(name)) return false;
    if (find_in_catalogue<3>(name)) return true;
    return is_mesh_ending(ending_of(name.substr(0, name.find(';'))));
}

}  // namespace

double LabelFont::width(std::string_view utf8) const {
    double sum = 0;
    for (const char c : utf8) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 128)
            sum += ascii[byte];
        else if (byte >= 0xc0)  // the first of a character
            sum += other;
    }
    return sum;
}

void open_state_on_page(Page& page, const std::string& text) {
    dimension_of_state(text, "state") == 3 ? open_state<3>(page, text, "state") : open_state<2>(page, text, "state");
}

std::string state_of_page(Page& page) {
    return with_bench(page, [](auto& on) { return bench_state(on.bench); });
}

std::string handout_of_page(Page& page) {
    return with_bench(page, [](auto& on) { return handout_text(on.bench); });
}

void open_on_page(Page& page, const std::string& name) {
    if (const auto text = state_text<2>(name))
        dimension_of_state(*text, name) == 3 ? open_state<3>(page, *text, name) : open_state<2>(page, *text, name);
    else if (is_3d(name))
        put(page, bench_of<3>(page, name));
    else
        put(page, bench_of<2>(page, name));
}

namespace {

struct Opening {
    std::string name;
    int dimension = 0;  ///< 0: what the name says
};

/// "viewer3d city:50k", "open streets"; nothing for any other command.
std::optional<Opening> opens_on_page(const Page& page, const std::string& commands) {
    const auto [word, rest] = split_word(commands);
    const int dimension = word == "viewer3d" ? 3 : word == "viewer2d" ? 2 : 0;
    if ((dimension == 0 && word != "open") || rest.find(';') != std::string::npos) return std::nullopt;
    std::string name = rest;
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    if (name.empty() && dimension == 0) return std::nullopt;
    if (name.empty()) name = dimension == 3 ? "city:50k" : "bottleneck";
    // Some scenes are there in both dimensions.
    const bool both = find_in_catalogue<2>(name) && find_in_catalogue<3>(name);
    return Opening{name, dimension == 0 && both ? (page.plane ? 2 : 3) : dimension};
}

void open_as(Page& page, const Opening& opening) {
    if (opening.dimension == 3)
        put(page, bench_of<3>(page, opening.name));
    else if (opening.dimension == 2)
        put(page, bench_of<2>(page, opening.name));
    else
        open_on_page(page, opening.name);
}

/// A lesson of the other dimension opens there.
void turn_to_lesson(Page& page, const std::string& commands) {
    const auto [word, rest] = split_word(commands);
    if (word != "lesson" || rest.empty()) return;
    const auto [id, part] = split_word(rest);
    for (const Lesson& lesson : read_lessons(lessons_of_the_project()))
        if (lesson.id == id && lesson.dimension != (page.plane ? 2 : 3))
            return open_as(page, {lesson.dimension == 3 ? "blocks" : "bottleneck", lesson.dimension});
}

}  // namespace

void run_on_page(Page& page, const std::string& commands) {
    ++page.revision;
    try {
        if (const auto opening = opens_on_page(page, commands)) return open_as(page, *opening);
        turn_to_lesson(page, commands);
        with_bench(page, [&](auto& on) { run_commands(on.bench, commands); });
    } catch (const std::bad_alloc&) {
        page.said.push_back({"this needs more memory than a page gets", true});
    } catch (const std::exception& error) {
        page.said.push_back({error.what(), true});
    }
}

void fly_on_page(Page& page, const Vec<3>& seconds, const Vec<2>& degrees) {
    if (!page.space) return;
    Workbench<3>& bench = page.space->bench;
    const int up = bench.session.scene().up_axis;
    const ViewSpec<3> aside = turned(bench.session.display_view(), up, degrees.x, degrees.y);
    fly_to(bench, walked(aside, up, seconds * flight_speed(bench)), "flight");
    ++page.revision;
}

bool tick(Page& page, double seconds) {
    const bool moved = with_bench(page, [&](auto& on) {
        auto& bench = on.bench;
        const std::uint32_t before = bench.session.position();
        if (bench.transport.playing) advance_clock(bench, seconds);
        bool any = bench.session.position() != before;
        any = advance_flight(bench, seconds) || any;
        return any;
    });
    page.revision += moved;
    return moved;
}

bool idle(Page& page, double milliseconds) {
    const bool told = with_bench(page, [&](auto& on) {
        auto& bench = on.bench;
        if (!stands_still(bench) || page.hand) return false;
        bool any = update_what_if(bench);
        any = update_faults(bench, bench.desk.right == "objects") || any;
        if (bench.desk.right == "trade-off") any = advance_trade_off(bench, milliseconds) || any;
        return any;
    });
    page.revision += told;
    return told;
}

}  // namespace sightline
