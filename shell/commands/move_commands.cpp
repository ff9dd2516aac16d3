// Commands that move along the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.h"
#include "core/base/number.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/frames.h"
#include "shell/desk/into.h"
#include "shell/desk/moves.h"
#include "shell/desk/play.h"

namespace sightline {

namespace {

std::uint32_t count(Text text) { return text.empty() ? 1 : whole_argument(text, "a number of steps"); }

template <int D>
void step(Workbench<D>& bench, Text text) {
    step_forward(bench, count(text));
}

template <int D>
void back(Workbench<D>& bench, Text text) {
    step_back(bench, count(text));
}

template <int D>
void seek(Workbench<D>& bench, Text text) {
    if (text == "start") return go_to_step(bench, 0);
    if (text == "end") return run_to_end(bench);
    if (text.starts_with('@')) {
        for (const Bookmark& bookmark : bench.session.bookmarks)
            if (bookmark.label == text.substr(1)) return go_to_step(bench, bookmark.step);
        throw InputError("there is no bookmark '" + text.substr(1) + "'");
    }
    go_to_step(bench, whole_argument(text, "a step, start, end or @BOOKMARK"));
}

/// Until the cell is projected, or back to where it was.
template <int D>
void reach(Workbench<D>& bench, Text text) {
    const std::uint32_t cell = cell_argument(bench, text);
    const std::uint32_t step = step_of_cell(bench, cell);
    if (step != none) return go_to_step(bench, step);
    bench.say("cell " + std::to_string(cell) + " is never projected in this run; still at step " +
              std::to_string(bench.session.position()));
}

template <int D>
void run_on(Workbench<D>& bench, Text) {
    run_to_breakpoint(bench);
    if (bench.last_stop != Stop::breakpoint)
        bench.say("no breakpoint was reached; the run ended at step " + std::to_string(bench.session.position()));
}

template <int D>
void start_playing(Workbench<D>& bench, Text text) {
    if (text.empty()) return play(bench);
    if (!text.ends_with('s')) throw InputError("'" + text + "' is not a time such as 20s");
    const double seconds = number_argument(text.substr(0, text.size() - 1), "a time such as 20s");
    if (!(seconds > 0)) throw InputError("'" + text + "' is not a time such as 20s");
    play_whole_run_in(bench, seconds);
}

template <int D>
void toggle_playing(Workbench<D>& bench, Text) {
    bench.transport.playing ? pause(bench) : play(bench);
}

template <int D>
void speed(Workbench<D>& bench, Text text) {
    double& speed = bench.transport.steps_per_second;
    const double asked = text == "half"     ? speed / 2
                         : text == "double" ? speed * 2
                                            : number_argument(text, "half, double or steps per second");
    if (!(asked > 0)) throw InputError("'" + text + "' is not a speed above 0");
    speed = std::clamp(asked, slowest, fastest);
    bench.say("speed: " + short_number(speed) + " steps a second");
}

template <int D>
void frame(Workbench<D>& bench, Text text) {
    if (text == "keep") return keep_frame(bench);
    if (text == "none") return forget_frames(bench);
    step_into_frame(bench, whole_argument(text, "a frame of the lane"));
}

constexpr std::array frames{NamedArgument{"Keep frame", "keep"}, NamedArgument{"Forget frames", "none"}};
constexpr std::array ten_steps{NamedArgument{"Ten steps", "10"}};
constexpr std::array ten_back{NamedArgument{"Ten steps back", "10"}};
constexpr std::array places{NamedArgument{"Go to the start", "start"}, NamedArgument{"Go to the end", "end"}};
constexpr std::array selected_cell{NamedArgument{"Run to selection", "selected"}};
constexpr std::array in_time{NamedArgument{"Play in 20 s", "20s"}};
constexpr std::array speeds{NamedArgument{"Play slower", "half"}, NamedArgument{"Play faster", "double"}};

}  // namespace

template <int D>
std::span<const Command<D>> move_commands() {
    static constexpr std::array table{
        Command<D>{"step", "Step", "[N]", "go one step forward, or N steps", "Right Shift+Right=10", step<D>, "",
                   ten_steps},
        Command<D>{"back", "Step back", "[N]", "go one step back, or N steps", "Left Shift+Left=10", back<D>, "",
                   ten_back},
        Command<D>{"into", "Step into", "", "into the step: one substep forward", "Down",
                   [](Workbench<D>& bench, Text) { step_into(bench); }},
        Command<D>{"out", "Step out", "", "one substep back; before the first one the step is undone", "Up",
                   [](Workbench<D>& bench, Text) { step_out(bench); }},
        Command<D>{"seek", "Go to step", "N | start | end | @LABEL", "go to a step, the start, the end or a bookmark",
                   "Home=start", seek<D>, "", places},
        Command<D>{"run", "Run to end", "", "run to the end: the budget is used up or the front is empty", "End",
                   [](Workbench<D>& bench, Text) { run_to_end(bench); }},
        Command<D>{"until", "Run until", "CONDITION", "run until step:N, cell:ID, object:NAME or an expression holds",
                   "U=?", [](Workbench<D>& bench, Text text) { run_until(bench, condition_for(bench.session, text)); }},
        Command<D>{"reach", "Run to cell", "ID | selected", "go to the step that projects a cell, forward or back",
                   "Enter=selected", reach<D>, "", selected_cell},
        Command<D>{"continue", "Continue", "", "run to the next breakpoint", "F5", run_on<D>},
        Command<D>{"play", "Play", "[20s]", "play at the chosen speed, or so that the whole run takes this long",
                   "Y=20s", start_playing<D>, "", in_time},
        Command<D>{"pause", "Pause", "", "stop playing", "", [](Workbench<D>& bench, Text) { pause(bench); }},
        Command<D>{"toggle", "Play or pause", "", "play the run step by step, or stop", "Space", toggle_playing<D>},
        Command<D>{"frame", "Frame", "N | keep | none",
                   "step into frame N of the lane, from 0; keep this frame as the one before; or forget the lane", "",
                   frame<D>, "", frames},
        Command<D>{"speed", "Speed", "half | double | N", "halve, double or set the steps per second",
                   "[=half ]=double", speed<D>, "", speeds},
    };
    return table;
}

template std::span<const Command<2>> move_commands<2>();
template std::span<const Command<3>> move_commands<3>();

}  // namespace sightline
