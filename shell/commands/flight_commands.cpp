// Commands that move the eye in 3D: circling, walking, flying along paths.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/scene/flight_path_csv.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/camera.h"
#include "shell/desk/change.h"
#include "shell/desk/fly.h"

namespace sightline {

namespace {

int up_axis(const Workbench<3>& bench) { return bench.session.scene().up_axis; }

Vec<2> degrees_argument(Text text) {
    const auto by = parse_pair(text);
    if (!by) throw InputError("write the degrees to the right and up as X,Y");
    return *by;
}

void orbit(Workbench<3>& bench, Text text) {
    const Vec<2> by = degrees_argument(text);
    change_view(bench, orbited(bench.session.display_view(), up_axis(bench), by.x, by.y));
}

void turn(Workbench<3>& bench, Text text) {
    const Vec<2> by = degrees_argument(text);
    change_view(bench, turned(bench.session.display_view(), up_axis(bench), by.x, by.y));
}

void walk(Workbench<3>& bench, Text text) {
    Vec<3> by;
    std::string_view rest = text;
    for (int i = 0; i < 3; ++i) {
        const std::size_t end = i < 2 ? rest.find(',') : rest.size();
        const auto number = end == std::string_view::npos ? std::nullopt : parse_number(rest.substr(0, end));
        if (!number) throw InputError("write how far to the right, up and forward as X,Y,Z");
        by[i] = *number;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    change_view(bench, walked(bench.session.display_view(), up_axis(bench), by));
}

void through(Workbench<3>& bench, Text) {
    if (!bench.session.frozen()) throw InputError("the view is not frozen: this is already the culling view");
    change_view(bench, bench.session.culling_view());
}

void fly(Workbench<3>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"off", "on"});
    bench.flight.on = text.empty() ? !bench.flight.on : word_argument(text, words) == 1;
    land_unless_moving(bench);
    bench.say(bench.flight.on ? "flying: W A S D Q E move, Shift faster, dragging turns, { } change the speed, F "
                                "freezes the view, Shift+C completes the picture where the eye rests, G lands"
                              : "landed: the frame is recorded and can be stepped through");
}

void set_speed(Workbench<3>& bench, Text text) {
    const bool factor = text.starts_with("x");
    const double number = number_argument(factor ? text.substr(1) : text, "a speed such as 5 or x2");
    const double asked = factor ? flight_speed(bench) * number : number;
    if (!(asked > 0 && std::isfinite(asked))) throw InputError("the speed must be above 0 and finite");
    bench.flight.speed = asked;
    bench.say("speed " + short_number(bench.flight.speed) + " units a second");
}

void step_path(Workbench<3>& bench, Text text, int sign) {
    const Flight<3>& flight = bench.flight;
    if (flight.path.frames.empty()) throw InputError("there is no path: name one, or record it");
    const auto by = static_cast<std::int64_t>(text.empty() ? 1 : whole_argument(text, "a number of frames"));
    const auto last = static_cast<std::int64_t>(flight.path.frames.size()) - 1;
    go_to_frame(bench, static_cast<std::uint32_t>(std::clamp<std::int64_t>(flight.frame + sign * by, 0, last)));
    land_unless_moving(bench);
}

/// Shows the path bar, with the scene's first path where none was chosen, or hides it.
void flip_path_bar(Workbench<3>& bench) {
    bench.flight.bar = !bench.flight.bar;
    const auto& paths = bench.session.scene().paths;
    if (bench.flight.bar && bench.flight.path.frames.empty() && !paths.empty()) choose_path(bench, paths.front().id);
}

/// What `path` makes of its first word; anything else is the id of a path.
struct PathWord {
    std::string_view word;
    void (*run)(Workbench<3>&, Text rest);
};
constexpr std::array path_words{
    PathWord{"", [](Workbench<3>& bench, Text) { flip_path_bar(bench); }},
    PathWord{"frame",
             [](Workbench<3>& bench, Text rest) {
                 go_to_frame(bench, whole_argument(rest, "a frame of the path"));
                 land_unless_moving(bench);
             }},
    PathWord{"start",
             [](Workbench<3>& bench, Text) {
                 go_to_frame(bench, 0);
                 land_unless_moving(bench);
             }},
    PathWord{"step", [](Workbench<3>& bench, Text rest) { step_path(bench, rest, 1); }},
    PathWord{"back", [](Workbench<3>& bench, Text rest) { step_path(bench, rest, -1); }},
    PathWord{"play", [](Workbench<3>& bench, Text) { replay(bench); }},
    PathWord{"stop",
             [](Workbench<3>& bench, Text) {
                 stop_path(bench);
                 bench.say("the path has " + std::to_string(bench.flight.path.frames.size()) + " frames");
             }},
    PathWord{"toggle", [](Workbench<3>& bench, Text) { bench.flight.replaying ? stop_path(bench) : replay(bench); }},
    PathWord{"loop",
             [](Workbench<3>& bench, Text) {
                 bench.flight.loop = !bench.flight.loop;
                 bench.say(bench.flight.loop ? "the path repeats" : "the path stops at its end");
             }},
    PathWord{"record",
             [](Workbench<3>& bench, Text) {
                 if (bench.flight.recording) return stop_path(bench);
                 record_path(bench);
                 bench.say("recording the flight: G flies, path stop ends the recording");
             }},
    PathWord{"save",
             [](Workbench<3>& bench, Text rest) {
                 if (bench.flight.path.frames.empty()) throw InputError("there is no path: name one, or record it");
                 write_file(file_argument(rest), path_text(bench.flight.path, rest));
                 bench.say("wrote " + rest);
             }},
    PathWord{"open", [](Workbench<3>& bench,
                        Text rest) { take_path(bench, read_path<3>(read_file(file_argument(rest)), rest)); }},
};

void path(Workbench<3>& bench, Text text) {
    const auto [word, rest] = split_word(text);
    const auto found = std::find_if(path_words.begin(), path_words.end(),
                                    [&word = word](const PathWord& known) { return known.word == word; });
    found != path_words.end() ? found->run(bench, rest) : choose_path(bench, word);
}

constexpr std::array orbits{NamedArgument{"Orbit right", "15,0"}, NamedArgument{"Orbit left", "-15,0"},
                            NamedArgument{"Orbit up", "0,15"}, NamedArgument{"Orbit down", "0,-15"}};
constexpr std::array flying_speeds{NamedArgument{"Fly faster", "x2"}, NamedArgument{"Fly slower", "x0.5"}};
constexpr std::array path_moves{NamedArgument{"Play path", "toggle"},    NamedArgument{"Next frame", "step"},
                                NamedArgument{"Previous frame", "back"}, NamedArgument{"Start of path", "start"},
                                NamedArgument{"Repeat path", "loop"},    NamedArgument{"Record path", "record"},
                                NamedArgument{"Save path", "save"}};

}  // namespace

template <>
std::span<const Command<2>> flight_commands<2>() {
    return {};
}

template <>
std::span<const Command<3>> flight_commands<3>() {
    static constexpr std::array table{
        Command<3>{"orbit", "Orbit", "RIGHT,UP", "circle about the point that the display view looks at, in degrees",
                   "Ctrl+Right=15,0 Ctrl+Left=-15,0 Ctrl+Up=0,15 Ctrl+Down=0,-15", orbit, "", orbits},
        Command<3>{"turn", "Turn", "RIGHT,UP", "turn the display view in place, in degrees", "", turn},
        Command<3>{"walk", "Walk", "RIGHT,UP,FORWARD", "move the display view, in scene units", "", walk},
        Command<3>{"through", "Frozen eye view", "", "look through the frozen eye", "I", through},
        Command<3>{"fly", "Fly", "[on | off]", "fly: keys and mouse move the eye, and the traversal follows it", "G",
                   fly},
        Command<3>{"fly-speed", "Flying speed", "UNITS | xFACTOR", "set the flying speed, in scene units per second",
                   "}=x2 {=x0.5", set_speed, "", flying_speeds},
        Command<3>{"path", "Flight path",
                   "[ID | frame N | start | step [N] | back [N] | play | stop | toggle | loop | record | save FILE | "
                   "open FILE]",
                   "show the path bar; choose, replay, record, save or open a flight path (frames count from 0)",
                   "Shift+P Shift+Space=toggle Shift+PageDown=step Shift+PageUp=back Shift+Home=start Shift+L=loop "
                   "Shift+R=record",
                   path, "", path_moves},
    };
    return table;
}

}  // namespace sightline
