// Commands that move the eye in 3D: circling, walking, flying along paths.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/error.h"
#include "core/file.h"
#include "core/number.h"
#include "shell/bench/camera.h"
#include "shell/bench/change.h"
#include "shell/bench/flight.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"

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
    if (!bench.session.frozen()) throw InputError("nothing is frozen: this is the culling view already");
    change_view(bench, bench.session.culling_view());
}

void fly(Workbench<3>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"off", "on"});
    bench.flight.on = text.empty() ? !bench.flight.on : word_argument(text, words) == 1;
    if (!bench.flight.on) land(bench);
    bench.say(bench.flight.on ? "flying: W A S D Q E move, the mouse turns, F freezes here, G lands"
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

/// ID | frame N | record | stop | save FILE | open FILE | play
void path(Workbench<3>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"frame", "record", "stop", "play", "save", "open"});
    const auto [word, rest] = split_word(text);
    const auto found = std::find(words.begin(), words.end(), word);
    Flight<3>& flight = bench.flight;
    switch (found - words.begin()) {
        case 0:
            go_to_frame(bench, whole_argument(rest, "a frame of the path"));
            break;
        case 1:
            flight.path = {
                "recorded", {bench.session.culling_view()}, bench.session.scene().id, bench.session.scene().origin};
            flight.recording = true;
            bench.say("recording the flight; path stop ends it");
            break;
        case 2:
            flight.recording = flight.replaying = false;
            land(bench);
            bench.say("the path has " + std::to_string(flight.path.frames.size()) + " frames");
            break;
        case 3:
            if (flight.path.frames.empty()) throw InputError("there is no path: name one, or record it");
            flight.recording = false;
            flight.replaying = true;
            break;
        case 4:
            write_file(file_argument(rest), write_path(flight.path));
            bench.say("wrote " + rest);
            break;
        case 5:
            flight.path = read_path<3>(read_file(file_argument(rest)), rest);
            set_origin(flight.path, bench.session.scene().origin);
            flight.frame = 0;
            break;
        default:
            choose_path(bench, word);
    }
}

}  // namespace

template <>
std::span<const Command<2>> flight_commands<2>() {
    return {};
}

template <>
std::span<const Command<3>> flight_commands<3>() {
    static constexpr std::array table{
        Command<3>{"orbit", "RIGHT,UP", "circle about the point that the display view looks at, by degrees",
                   "Ctrl+Right=15,0 Ctrl+Left=-15,0 Ctrl+Up=0,15 Ctrl+Down=0,-15", orbit},
        Command<3>{"turn", "RIGHT,UP", "turn the display view on the spot, by degrees", "", turn},
        Command<3>{"walk", "RIGHT,UP,FORWARD", "move the display view, in scene units", "", walk},
        Command<3>{"through", "", "look through the frozen eye", "I", through},
        Command<3>{"fly", "[on | off]", "the traversal follows the eye, which keys and mouse move", "G", fly},
        Command<3>{"fly-speed", "UNITS | xFACTOR", "of flying, in scene units a second", "}=x2 {=x0.5", set_speed},
        Command<3>{"path", "ID | frame N | record | stop | play | save FILE | open FILE",
                   "choose a flight path of the scene, show a frame of it (from 0), record or replay one", "", path},
    };
    return table;
}

}  // namespace sightline
