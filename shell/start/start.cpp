// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/start/start.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/session/condition.h"
#include "core/session/headline.h"
#include "core/session/report.h"
#include "core/session/settings_file.h"
#include "core/session/state_file.h"
#include "shell/commands/arguments.h"
#include "shell/commands/command_table.h"
#include "shell/desk/auto_choice.h"
#include "shell/desk/change.h"
#include "shell/desk/compare.h"
#include "shell/desk/fly.h"
#include "shell/desk/moves.h"
#include "shell/desk/open_scene.h"
#include "shell/desk/recent.h"
#include "shell/export/export.h"
#include "shell/gl/context.h"
#include "shell/start/options.h"
#include "shell/start/terminal_progress.h"
#include "shell/window/memory.h"
#include "shell/window/window.h"

namespace sightline {

namespace {

void apply_options(Settings& settings, const Options& o) {
    if (o.automatic) settings.automatic = Switch::on;
    if (!o.preset.empty()) apply_preset(settings, o.preset);
    if (!o.settings_file.empty())
        for (const std::string& assignment : read_settings(read_file(o.settings_file), o.settings_file))
            apply_setting(settings, assignment);
    if (!o.method.empty()) settings.method = o.method;
    if (!o.budget.empty()) settings.budget = parse_budget(o.budget);
    for (const std::string& assignment : o.settings) apply_setting(settings, assignment);
    if (!o.up.empty()) apply_setting(settings, "up=" + o.up);
}

template <int D>
ViewSpec<D> apply_options(ViewSpec<D> view, const Options& o, const Scene<D>& scene) {
    if (!o.eye.empty()) view.eye = parse_point(o.eye, scene);
    if (!o.look_at.empty()) view.look_at = parse_point(o.look_at, scene);
    if (o.fov) view.fov = *o.fov;
    return view;
}

void warn(const std::string& line) { std::cerr << "warning: " << line << "\n"; }

/// What --budget, a settings file or --set says; nothing for one in milliseconds, which no measurement has.
std::optional<Budget> asked_budget(const Options& o) {
    const Budget nobody_asks{Budget::Kind::primitives, -1};
    Settings asked;
    asked.budget = nobody_asks;
    apply_options(asked, o);
    if (asked.budget == nobody_asks || asked.budget.kind == Budget::Kind::milliseconds) return std::nullopt;
    return asked.budget;
}

/// Where `auto` is asked for, or on in the state of another scene; what else is asked for stands over what is
/// recommended.
template <int D>
void follow_recommendation(Workbench<D>& bench, const Options& o, bool state_of_another_scene) {
    Settings asked;
    if (state_of_another_scene) asked.automatic = bench.session.settings().automatic;
    apply_options(asked, o);
    if (asked.automatic == Switch::off) return;
    const std::optional<Budget> budget = asked_budget(o);
    choose_auto(bench, false, bench.session.settings(), budget);
    Settings settings = bench.session.settings();
    apply_options(settings, o);
    if (budget) settings.automatic = Switch::off;
    change_settings(bench, settings);
    if (budget) bench.say("auto is off: the budget was set by hand");
}

/// What the file says that --state names: perhaps a figure, which people have and look at.
std::string text_of_state(const std::string& name) {
    std::string text = read_file(name);
    const std::size_t first = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
    if (const std::size_t at = text.find_first_not_of(" \t\r\n", first); at != std::string::npos && text[at] == '{')
        return text;
    std::error_code error;
    const std::string sidecar = name + ".json";
    throw InputError(name + ": is not a state file" +
                     (std::filesystem::exists(sidecar, error) ? ": its sidecar is " + sidecar : ""));
}

/// What is to be opened.
struct Asked {
    std::string name;                  ///< of a scene, or of the state file
    std::optional<std::string> state;  ///< what the state file says
    bool of_another_scene = false;     ///< the state, than the one that it was opened with
};

template <int D>
Asked asked_for(const Options& o) {
    if (!o.state.empty()) return {o.state, text_of_state(o.state)};
    const std::string name = o.scene.empty() ? first_scene : o.scene;
    const Asked asked{name, state_text<D>(name)};
    if (asked.state && !o.cells.empty()) throw InputError("--cells needs a scene: " + name + " is a state file");
    return asked;
}

template <int D>
Session<D> open_session(const Options& o, const std::string& name, bool in_window, std::span<const Method<D>> methods,
                        const Graphics& graphics) {
    Settings settings = start_settings<D>(name, in_window);
    apply_options(settings, o);
    std::error_code error;
    const bool made = !o.cells.empty() && std::filesystem::exists(o.cells, error);
    return open_scene<D>(
        name, settings, methods, warn, graphics, made ? o.cells : "",
        [&o](const ViewSpec<D>& view, const Scene<D>& scene) { return apply_options<D>(view, o, scene); },
        o.eye.empty() || o.look_at.empty());
}

template <int D>
Workbench<D> open_bench(const Options& o, Asked& asked, bool in_window, std::span<const Method<D>> methods,
                        const Graphics& graphics) {
    // JSON on standard output stays alone there.
    std::ostream& out = o.stats == "-" || o.trace == "-" ? std::cerr : std::cout;
    const auto say = [&out](const std::string& line) { out << line << "\n"; };
    if (!asked.state) {
        Workbench<D> bench{
            open_session<D>(o, asked.name, in_window, methods, graphics), {}, Stop::steps, false, say, methods};
        bench.graphics = graphics;
        if (std::error_code error; !o.cells.empty() && !std::filesystem::exists(o.cells, error))
            write_cells(bench, o.cells);
        return bench;
    }
    OpenedState<D> opened = open_state<D>(*asked.state, asked.name, methods, graphics.draw_ids, graphics.progress,
                                          o.state.empty() ? "" : o.scene);
    for (const std::string& warning : opened.warnings) warn(warning);
    for (const std::string& warning : opened.session.scene().warnings) warn(warning);
    asked.of_another_scene = opened.of_another_scene;
    Settings settings = opened.session.settings();
    apply_options(settings, o);
    const std::string left =
        settings.automatic == Switch::on ? left_auto(opened.session.settings(), settings) : std::string();
    if (!left.empty()) settings.automatic = Switch::off;
    if (difference(opened.session.settings(), settings) == Invalidates::scene)
        throw InputError(
            "two_sided, up and degrees decide how the scene is read: they cannot be changed in a state file");
    opened.session.change(settings);
    const ViewSpec<D> view = apply_options<D>(opened.session.culling_view(), o, opened.session.scene());
    if (view != opened.session.culling_view()) opened.session.set_view(view);
    Workbench<D> bench{std::move(opened.session), std::move(opened.figure), Stop::steps, false, say, methods};
    bench.graphics = graphics;
    if (opened.other) compare_with(bench, std::move(*opened.other), "right", opened.align);
    return bench;
}

/// As open_bench. Where no scene was asked for: the one that was opened last, or the first one where that is gone;
/// `asked` is what became of it.
template <int D>
Workbench<D> open_last(const Options& o, Asked& asked, bool in_window, Recalled& recalled,
                       std::span<const Method<D>> methods, const Graphics& graphics) {
    asked = asked_for<D>(o);
    if (!o.scene.empty() || !o.state.empty() || recalled.memory.recent.empty())
        return open_bench<D>(o, asked, in_window, methods, graphics);
    const std::string& last = recalled.memory.recent.front();
    try {
        Asked again{last, state_text<D>(last)};
        Workbench<D> bench = open_bench<D>(o, again, in_window, methods, graphics);
        asked = again;
        return bench;
    } catch (const InputError& error) {
        // Throws again where the options are to blame.
        Workbench<D> bench = open_bench<D>(o, asked, in_window, methods, graphics);
        recalled.word +=
            (recalled.word.empty() ? "" : "; ") + std::string("the last scene cannot be opened: ") + error.what();
        recalled.memory.recent.erase(recalled.memory.recent.begin());
        note_opened<D>(recalled.memory.recent, first_scene);
        return bench;
    }
}

/// The window as it was the last time, and as the options ask.
template <int D>
void arrange(Workbench<D>& bench, const Options& o, Recalled& recalled) {
    bench.desk = recalled.memory.desk;
    if (o.window) recalled.memory.placement = {(*o.window)[0], (*o.window)[1], std::nullopt, false};
    bench.recent = recalled.memory.recent;
    const std::string asked = o.state.empty() ? o.scene : o.state;
    if (!asked.empty() || bench.recent.empty()) note_opened<D>(bench.recent, asked.empty() ? first_scene : asked);
}

/// Without a word about where to stand, a run without a window goes to its end, and so does a window in 3D, where the
/// start shows nothing; in 2D it waits at the start.
template <int D>
void move(Workbench<D>& bench, const Options& o, bool state, bool window) {
    const bool asked = (D == 2 && window) || o.steps || !o.until.empty() || !o.commands.empty();
    if (!asked && !state) run_to_end(bench);
    if (!asked && state) go_to_step(bench, bench.session.position());
    if (!o.commands.empty()) run_commands(bench, o.commands);
    if (!o.until.empty()) {
        const Condition<D> condition = condition_for(bench.session, o.until);
        go_to_step(bench, 0);
        run_until(bench, condition);
    }
    if (o.steps) go_to_step(bench, *o.steps);
}

template <int D>
std::string wrong_text(const Session<D>& s) {
    return short_number(100 * s.wrong_pixels()) + " %";
}

template <int D>
void print_summary(const Workbench<D>& bench) {
    const Session<D>& s = bench.session;
    const Reference& reference = s.reference();
    const auto inversions = s.inversions();
    const auto so_far =
        std::count_if(inversions.begin(), inversions.end(), [&](const Inversion& i) { return i.step <= s.position(); });
    bench.say(conditions(s));
    bench.say("Step " + std::to_string(s.position()) +
              " (stopped by: " + std::string(stop_words[static_cast<std::size_t>(bench.last_stop)]) +
              "): " + std::to_string(s.counters().drawn()) + " rendered, " + std::to_string(s.visible_rendered()) +
              " of " + std::to_string(reference.count) + " visible; coverage " +
              (reference.count == 0 ? std::string("none (nothing is visible)")
                                    : coverage_text(coverage(reference, s.visible_rendered()))) +
              (D == 2 ? " (exact reference)" : " (" + reference.name + "), wrong pixels " + wrong_text(s)) +
              ", inversions " + std::to_string(so_far) + ", state " + hash_text(s.hash()));
    if (s.cells().cell_count() == 0) std::cerr << "warning: no cells: too few leaf centres without a border\n";
    if (reference.eye_on > 0)
        std::cerr << "warning: the eye lies on " << reference.eye_on
                  << (reference.eye_on == 1 ? " segment, which subtends" : " segments, which subtend")
                  << " no angle there: not visible\n";
    if (s.cells().unassigned > 0)
        std::cerr << "warning: " << s.cells().unassigned << (D == 2 ? " segments" : " triangles")
                  << " lie in no cell and are never rendered (border="
                  << words<Border>[static_cast<std::size_t>(s.settings().border)] << ")\n";
}

/// The path and the frame that were asked for.
template <int D>
void start_path(Workbench<D>& bench, const Options& o) {
    if (o.path.empty()) return;
    const auto& paths = bench.session.scene().paths;
    const bool known = std::any_of(paths.begin(), paths.end(), [&](const FlightPath<D>& p) { return p.id == o.path; });
    if (!known && std::filesystem::exists(o.path))
        take_path(bench, read_path<D>(read_file(o.path), o.path));
    else
        choose_path(bench, o.path);
    if (!o.frame) return;
    go_to_frame(bench, *o.frame);
    land(bench);
}

/// The statistics of some frames of the path, one after the other.
template <int D>
std::string path_stats(Workbench<D>& bench, std::uint32_t frames) {
    std::string text = "[";
    for (const std::size_t frame : spread_frames(bench.flight.path.frames.size(), frames)) {
        go_to_frame(bench, static_cast<std::uint32_t>(frame));
        const double traverse = bench.session.times().traverse;
        land(bench);
        Times& times = bench.session.times();
        times.traverse = traverse;  // of the flight: recording takes longer
        times.reference = 0;
        text += (text.size() > 1 ? ",\n" : "\n") + ("{\"frame\": " + std::to_string(frame) + ", \"stats\": ") +
                stats_json(bench.session, bench.last_stop) + "}";
    }
    return text + "\n]\n";
}

/// What `--panels` asks for, in its order.
std::vector<std::string> split_panels(const std::string& text) {
    std::vector<std::string> panels;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(';', begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        const std::size_t first = part.find_first_not_of(' ');
        if (first != std::string::npos) panels.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
        begin = end + 1;
    }
    return panels;
}

/// What is left to do where a library ends the program, as Xlib does when its server is lost.
class LastWill {
public:
    explicit LastWill(std::function<void()> will) {
        the_will() = std::move(will);  // made before the next line, so destroyed after what that registers
        [[maybe_unused]] static const int registered = std::atexit([] {
            if (const std::function<void()> last = std::exchange(the_will(), nullptr)) last();
        });
    }
    ~LastWill() { the_will() = nullptr; }
    LastWill(const LastWill&) = delete;
    LastWill& operator=(const LastWill&) = delete;

private:
    // Functions that are called at the end get no argument.
    static std::function<void()>& the_will() {
        static std::function<void()> will;
        return will;
    }
};

/// A terminal that is closed ends the window as SIGTERM does, which SDL turns into an event; unless nohup said no.
void end_by_hang_up() {
    const auto before = std::signal(SIGHUP, [](int) { std::raise(SIGTERM); });
    if (before == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

/// The window with what it remembers from one time to the next.
template <int D>
struct KeptWindow {
    Workbench<D>& bench;
    std::filesystem::path memory;
    std::vector<std::string> known;  ///< the recent names that are in the file, as far as this window knows
    Window<D> window;

    KeptWindow(Workbench<D>& on, const WindowOptions& options, const std::filesystem::path& file,
               std::vector<std::string> in_file)
        : bench(on), memory(file), known(std::move(in_file)), window(on, options) {}

    void remember() {
        known = keep<D>(memory, {window.placement(), lasting(bench.desk), bench.recent}, known);
        bench.recent = known;
    }
    void run() {
        const LastWill will([this] {
            try {
                remember();
            } catch (const std::exception&) {  // nobody is left to be told
            }
        });
        end_by_hang_up();
        window.opened = [this] {
            try {
                remember();
            } catch (const WorkError& error) {
                window.tell({error.what(), true});
            }
        };
        window.run();
        try {
            remember();
        } catch (const WorkError& error) {
            std::cerr << "warning: " << error.what() << "\n";
        }
    }
};

template <int D>
void obey(const Options& o, std::span<const Method<D>> methods, const Viewer<D>& viewer) {
    std::optional<Display> display;
    if (!o.headless) display.emplace();
    const bool in_window = display && display->found();
    if (!o.headless && !in_window) std::cerr << viewer.name << ": no display found; running as with --headless\n";
    Recalled recalled;
    const std::filesystem::path memory = memory_file(viewer.name);
    if (in_window) recalled = recall<D>(memory);
    const std::vector<std::string> in_file = recalled.memory.recent;
    Graphics graphics = viewer.graphics;
    graphics.progress = terminal_progress();
    Asked asked;
    Workbench<D> bench = open_last<D>(o, asked, in_window, recalled, methods, graphics);
    if (in_window) arrange(bench, o, recalled);
    // What follows may need OpenGL, which in 3D is the window's.
    std::optional<KeptWindow<D>> window;
    if (in_window) {
        // An asked scale stands for what the screen's density would ask, and is not remembered.
        const WindowOptions options{.placement = recalled.memory.placement, .scale = o.scale.value_or(0)};
        window.emplace(bench, options, memory, in_file);
        window->window.stage = viewer.stage(bench);
        if (!recalled.word.empty()) window->window.tell({recalled.word, true});
    }
    if (!asked.state) add_bookmarks(bench.session);
    if (!o.size.empty()) set_figure_size(bench, o.size);
    if (o.font_pt) bench.figure.font_pt = *o.font_pt;
    if (o.dpi) bench.figure.dpi = *o.dpi;
    if (o.columns) bench.figure.columns = *o.columns;
    if (!o.panels.empty()) bench.figure.panels = split_panels(o.panels);
    start_path(bench, o);
    bench.auto_file = auto_file();
    bench.page = o.page;
    follow_recommendation(bench, o, asked.of_another_scene);
    if (o.frames) return write_text(o.stats, path_stats(bench, *o.frames));
    move(bench, o, asked.state.has_value(), in_window);
    if (!in_window || o.writes()) print_summary(bench);
    for (const std::string& file : o.shots) write_shot(bench, file);
    if (!o.trace.empty()) write_text(o.trace, trace_json(bench.session));
    if (!o.stats.empty()) write_text(o.stats, stats_json(bench.session, bench.last_stop));
    if (window && !bench.quit) window->run();
}

int failed(const std::string& program, const char* what, int status) {
    std::cerr << program << ": " << one_line(what, 4096) << "\n";
    return status;
}

}  // namespace

template <int D>
int start(int argc, const char* const* argv, std::span<const Method<D>> methods, const Viewer<D>& viewer) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is told like a full disk
    try {
        const std::optional<Options> options = parse_options<D>(argc, argv, methods);
        if (!options) return 0;
        if (options->list)
            viewer.print_catalogue();
        else
            obey<D>(*options, methods, viewer);
        std::cout.flush();
        if (!std::cout) throw WorkError("standard output: cannot be written");
        return 0;
    } catch (const InputError& error) {
        return failed(viewer.name, error.what(), 2);
    } catch (const std::bad_alloc&) {
        return failed(viewer.name, "out of memory", 1);
    } catch (const std::exception& error) {
        return failed(viewer.name, error.what(), 1);
    }
}

template int start<2>(int, const char* const*, std::span<const Method<2>>, const Viewer<2>&);
template int start<3>(int, const char* const*, std::span<const Method<3>>, const Viewer<3>&);

}  // namespace sightline
