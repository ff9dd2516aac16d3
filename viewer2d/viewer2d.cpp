// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/viewer2d.h"

#include <iostream>
#include <new>
#include <optional>

#include "core/error.h"
#include "core/file.h"
#include "core/number.h"
#include "core/scene/catalogue.h"
#include "core/scene/load.h"
#include "core/scene/text.h"
#include "core/session/condition.h"
#include "core/session/report.h"
#include "core/session/state_file.h"
#include "core/stopwatch.h"
#include "shell/bench/export.h"
#include "shell/bench/moves.h"
#include "shell/bench/open.h"
#include "shell/bench/recent.h"
#include "shell/commands/arguments.h"
#include "shell/commands/command_table.h"
#include "shell/gl/context.h"
#include "shell/window/memory.h"
#include "viewer2d/options.h"
#include "viewer2d/window2d.h"

namespace sightline {

namespace {

void print_catalogue() {
    for (const CatalogueRow<2>& row : catalogue()) {
        std::string id = row.id;
        id.resize(14, ' ');
        std::cout << id << row.title << " (" << make_scene(row).primitives.size() << " segments, seed " << row.seed
                  << "). " << row.lesson << "\n";
    }
    const auto maps = installed_maps();
    if (maps.empty()) {
        std::cout << "No Freedoom levels found: Debian's package freedoom has dozens.\n";
    } else {
        std::cout << "Levels of the installed package freedoom:";
        for (const std::string& map : maps) std::cout << ' ' << map;
        std::cout << "\n";
    }
}

void apply_options(Settings& settings, const Options& o) {
    if (!o.preset.empty()) apply_preset(settings, o.preset);
    if (!o.method.empty()) settings.method = o.method;
    if (!o.budget.empty()) settings.budget = parse_budget(o.budget);
    for (const std::string& assignment : o.settings) apply_setting(settings, assignment);
}

ViewSpec<2> apply_options(ViewSpec<2> view, const Options& o, const Scene<2>& scene) {
    if (!o.eye.empty()) view.eye = parse_point(o.eye, scene);
    if (!o.look_at.empty()) view.look_at = parse_point(o.look_at, scene);
    if (o.fov) view.fov = *o.fov;
    return view;
}

void warn(const std::string& line) { std::cerr << "warning: " << line << "\n"; }

Session<2> open_session(const Options& o, bool in_window, std::span<const Method<2>> methods) {
    const std::string name = o.scene.empty() ? first_scene : o.scene;
    Settings settings = start_settings(name, in_window);
    apply_options(settings, o);
    Session<2> session = open_scene(name, settings, methods, warn);
    const ViewSpec<2> view = apply_options(session.culling_view(), o, session.scene());
    if (view != session.culling_view()) session.set_view(view);
    add_bookmarks(session);
    return session;
}

Workbench<2> open_bench(const Options& o, bool in_window, std::span<const Method<2>> methods) {
    // JSON on standard output stays alone there.
    std::ostream& out = o.stats == "-" || o.trace == "-" ? std::cerr : std::cout;
    const auto say = [&out](const std::string& line) { out << line << "\n"; };
    if (o.state.empty()) return {open_session(o, in_window, methods), {}, Stop::steps, false, say, methods};
    OpenedState opened = open_state(read_file(o.state), o.state, methods);
    for (const std::string& warning : opened.warnings) warn(warning);
    for (const std::string& warning : opened.session.scene().warnings) warn(warning);
    Settings settings = opened.session.settings();
    apply_options(settings, o);
    if (difference(opened.session.settings(), settings) == Invalidates::scene)
        throw InputError("two_sided decides how the scene is read: it cannot be changed in a state file");
    opened.session.change(settings);
    const ViewSpec<2> view = apply_options(opened.session.culling_view(), o, opened.session.scene());
    if (view != opened.session.culling_view()) opened.session.set_view(view);
    Workbench<2> bench{std::move(opened.session), std::move(opened.figure), Stop::steps, false, say, methods};
    if (opened.other) compare_with(bench, std::move(*opened.other), "right", opened.align);
    return bench;
}

/// As open_bench. Where no scene was asked for: the one that was opened last, or the first one where that is gone.
Workbench<2> open_last(const Options& o, bool in_window, Recalled& recalled, std::span<const Method<2>> methods) {
    if (!o.scene.empty() || !o.state.empty() || recalled.memory.recent.empty())
        return open_bench(o, in_window, methods);
    const std::string& last = recalled.memory.recent.front();
    try {
        Options again = o;
        (state_text(last) ? again.state : again.scene) = last;
        return open_bench(again, in_window, methods);
    } catch (const InputError& error) {
        Workbench<2> bench = open_bench(o, in_window, methods);  // throws again where the options are to blame
        recalled.word +=
            (recalled.word.empty() ? "" : "; ") + std::string("the last scene does not open: ") + error.what();
        recalled.memory.recent.erase(recalled.memory.recent.begin());
        note_opened(recalled.memory.recent, first_scene);
        return bench;
    }
}

/// The window as it was the last time, and as the options ask.
void arrange(Workbench<2>& bench, const Options& o, Recalled& recalled) {
    bench.desk = recalled.memory.desk;
    if (o.window) recalled.memory.placement = {(*o.window)[0], (*o.window)[1], std::nullopt, false};
    bench.recent = recalled.memory.recent;
    const std::string asked = o.state.empty() ? o.scene : o.state;
    if (!asked.empty() || bench.recent.empty()) note_opened(bench.recent, asked.empty() ? first_scene : asked);
}

/// Without a word about where to stand, a run without a window goes to its end; a window waits at the start.
void move(Workbench<2>& bench, const Options& o, bool window) {
    const bool asked = window || o.steps || !o.until.empty() || !o.commands.empty();
    if (!asked && o.state.empty()) run_to_end(bench);
    if (!asked && !o.state.empty()) go_to_step(bench, bench.session.position());
    if (!o.commands.empty()) run_commands(bench, o.commands);
    if (!o.until.empty()) {
        const Condition<2> condition(o.until);
        go_to_step(bench, 0);
        run_until(bench, condition);
    }
    if (o.steps) go_to_step(bench, *o.steps);
}

std::string value(const std::optional<double>& v) { return v ? short_number(*v) : "none (nothing is visible)"; }

void print_summary(const Workbench<2>& bench) {
    const Session<2>& s = bench.session;
    const Reference& reference = s.reference();
    const auto inversions = s.inversions();
    const auto so_far =
        std::count_if(inversions.begin(), inversions.end(), [&](const Inversion& i) { return i.step <= s.position(); });
    bench.say(conditions(s));
    bench.say("Step " + std::to_string(s.position()) +
              " (stopped by: " + std::string(stop_words[static_cast<std::size_t>(bench.last_stop)]) +
              "): " + std::to_string(s.state().rendered_count) + " rendered, " + std::to_string(s.visible_rendered()) +
              " of " + std::to_string(reference.count) + " visible; coverage " +
              value(coverage(reference, s.visible_rendered())) + " (exact reference), inversions " +
              std::to_string(so_far) + ", state " + hash_text(s.hash()));
    if (s.cells().cell_count() == 0) std::cerr << "warning: no cells: too few leaf centres without a border\n";
    if (reference.eye_on > 0)
        std::cerr << "warning: the eye lies on " << reference.eye_on
                  << (reference.eye_on == 1 ? " segment, which subtends" : " segments, which subtend")
                  << " no angle there: not visible\n";
    if (s.cells().unassigned > 0)
        std::cerr << "warning: " << s.cells().unassigned << " segments lie in no cell and are never rendered (border="
                  << words<Border>[static_cast<std::size_t>(s.settings().border)] << ")\n";
}

void obey(const Options& o, std::span<const Method<2>> methods) {
    std::optional<Display> display;
    if (!o.headless) display.emplace();
    const bool window = display && display->found();
    if (!o.headless && !window) std::cerr << "viewer2d: no display found; doing the same as with --headless\n";
    Recalled recalled;
    const std::filesystem::path memory = memory_file("viewer2d");
    if (window) recalled = recall<2>(memory);
    Workbench<2> bench = open_last(o, window, recalled, methods);
    if (window) arrange(bench, o, recalled);
    if (!o.size.empty()) set_figure_size(bench, o.size);
    if (o.font_pt) bench.figure.font_pt = *o.font_pt;
    if (!o.panels.empty()) {
        bench.figure.panels.clear();
        for (std::size_t begin = 0; begin <= o.panels.size();) {
            const std::size_t end = std::min(o.panels.find(';', begin), o.panels.size());
            const std::string part = o.panels.substr(begin, end - begin);
            const std::size_t first = part.find_first_not_of(' ');
            if (first != std::string::npos)
                bench.figure.panels.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
            begin = end + 1;
        }
    }
    move(bench, o, window);
    if (!window || o.writes()) print_summary(bench);
    for (const std::string& file : o.shots) write_shot(bench, file);
    if (!o.trace.empty()) write_text(o.trace, trace_json(bench.session));
    if (!o.stats.empty()) write_text(o.stats, stats_json(bench.session, bench.last_stop));
    if (window && !bench.quit) {
        // An asked scale stands for what the screen's density would ask, and is not remembered.
        const WindowOptions options{.placement = recalled.memory.placement, .scale = o.scale.value_or(0)};
        run_window(bench, options, memory, recalled.word);
    }
}

int report(const char* what, int status) {
    std::cerr << "viewer2d: " << one_line(what, 4096) << "\n";
    return status;
}

}  // namespace

int viewer2d(int argc, const char* const* argv, std::span<const Method<2>> methods) {
    try {
        const std::optional<Options> options = parse_options(argc, argv, methods);
        if (!options) return 0;
        if (options->list)
            print_catalogue();
        else
            obey(*options, methods);
        std::cout.flush();
        if (!std::cout) throw WorkError("standard output: cannot be written");
        return 0;
    } catch (const InputError& error) {
        return report(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return report("out of memory", 1);
    } catch (const std::exception& error) {
        return report(error.what(), 1);
    }
}

}  // namespace sightline
