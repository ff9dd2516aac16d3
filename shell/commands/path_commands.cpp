// Commands that choose, record, replay and save flight paths.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/flight_path_csv.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/fly.h"

namespace sightline {

namespace {

template <int D>
void step_path(Workbench<D>& bench, Text text, int sign) {
    const Flight<D>& flight = bench.flight;
    if (flight.path.frames.empty()) throw InputError("there is no path: name one, or record it");
    const auto by = static_cast<std::int64_t>(text.empty() ? 1 : whole_argument(text, "a number of frames"));
    const auto last = static_cast<std::int64_t>(flight.path.frames.size()) - 1;
    go_to_frame(bench, static_cast<std::uint32_t>(std::clamp<std::int64_t>(flight.frame + sign * by, 0, last)));
    land_unless_moving(bench);
}

/// Shows the path bar, with the scene's first path where none was chosen, or hides it.
template <int D>
void flip_path_bar(Workbench<D>& bench) {
    bench.flight.bar = !bench.flight.bar;
    const auto& paths = bench.session.scene().paths;
    if (bench.flight.bar && bench.flight.path.frames.empty() && !paths.empty()) choose_path(bench, paths.front().id);
}

/// What `path` makes of its first word; anything else is the id of a path.
template <int D>
struct PathWord {
    std::string_view word;
    void (*run)(Workbench<D>&, Text rest);
};
template <int D>
constexpr std::array path_words{
    PathWord<D>{"", [](Workbench<D>& bench, Text) { flip_path_bar(bench); }},
    PathWord<D>{"frame",
                [](Workbench<D>& bench, Text rest) {
                    go_to_frame(bench, whole_argument(rest, "a frame of the path"));
                    land_unless_moving(bench);
                }},
    PathWord<D>{"start",
                [](Workbench<D>& bench, Text) {
                    go_to_frame(bench, 0);
                    land_unless_moving(bench);
                }},
    PathWord<D>{"step", [](Workbench<D>& bench, Text rest) { step_path(bench, rest, 1); }},
    PathWord<D>{"back", [](Workbench<D>& bench, Text rest) { step_path(bench, rest, -1); }},
    PathWord<D>{"play", [](Workbench<D>& bench, Text) { replay(bench); }},
    PathWord<D>{"stop",
                [](Workbench<D>& bench, Text) {
                    stop_path(bench);
                    bench.say("the path has " + std::to_string(bench.flight.path.frames.size()) + " frames");
                }},
    PathWord<D>{"toggle", [](Workbench<D>& bench, Text) { bench.flight.replaying ? stop_path(bench) : replay(bench); }},
    PathWord<D>{"loop",
                [](Workbench<D>& bench, Text) {
                    bench.flight.loop = !bench.flight.loop;
                    bench.say(bench.flight.loop ? "the path repeats" : "the path stops at its end");
                }},
    PathWord<D>{"record",
                [](Workbench<D>& bench, Text) {
                    if (bench.flight.recording) return stop_path(bench);
                    record_path(bench);
                    bench.say(std::string("recording the path: ") + (D == 2 ? "drag the eye" : "G flies") +
                              ", Shift+R ends the recording");
                }},
    PathWord<D>{"save",
                [](Workbench<D>& bench, Text rest) {
                    if (bench.flight.path.frames.empty()) throw InputError("there is no path: name one, or record it");
                    write_file(file_argument(rest), path_text(bench.flight.path, rest));
                    bench.say("wrote " + rest);
                }},
    PathWord<D>{"open", [](Workbench<D>& bench,
                           Text rest) { take_path(bench, read_path<D>(read_file(file_argument(rest)), rest)); }},
};

template <int D>
void path(Workbench<D>& bench, Text text) {
    const auto [word, rest] = split_word(text);
    const auto found = std::find_if(path_words<D>.begin(), path_words<D>.end(),
                                    [&word = word](const PathWord<D>& known) { return known.word == word; });
    found != path_words<D>.end() ? found->run(bench, rest) : choose_path(bench, word);
}

constexpr std::array path_moves{NamedArgument{"Play path", "toggle"},    NamedArgument{"Next frame", "step"},
                                NamedArgument{"Previous frame", "back"}, NamedArgument{"Start of path", "start"},
                                NamedArgument{"Repeat path", "loop"},    NamedArgument{"Record path", "record"},
                                NamedArgument{"Save path", "save"}};

}  // namespace

template <int D>
std::span<const Command<D>> path_commands() {
    static constexpr std::array table{
        Command<D>{"path", "Flight path",
                   "[ID | frame N | start | step [N] | back [N] | play | stop | toggle | loop | record | save FILE | "
                   "open FILE]",
                   "show the path bar; choose, replay, record, save or open a flight path (frames count from 0)",
                   "Shift+P Shift+Space=toggle Shift+PageDown=step Shift+PageUp=back Shift+Home=start Shift+L=loop "
                   "Shift+R=record",
                   path<D>, "", path_moves},
    };
    return table;
}

template std::span<const Command<2>> path_commands<2>();
template std::span<const Command<3>> path_commands<3>();

}  // namespace sightline
