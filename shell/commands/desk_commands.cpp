// Commands that arrange the window. Without one they are kept, and do nothing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/moves.h"
#include "shell/panels/panel.h"

namespace sightline {

namespace {

/// Shows the panel in its column, or hides the column when it is there already.
template <int D>
void show(Workbench<D>& bench, Text text) {
    Desk& desk = bench.desk;
    if (text == "timeline" || text == "legend") {
        bool& on = text == "legend" ? desk.legend : desk.timeline;
        on = !on;
        return;
    }
    const Panel<D>* panel = find_panel<D>(text);
    if (!panel) {
        std::vector<std::string_view> known{"timeline", "legend"};
        for (const Panel<D>& p : panel_table<D>()) known.push_back(p.id);
        throw unknown_word("panel", text, known);
    }
    std::string& column = panel->column == Column::left ? desk.left : desk.right;
    column = column == text ? "" : text;
}

template <int D>
void scale(Workbench<D>& bench, Text text) {
    double& scale = bench.desk.scale;
    const double asked = text == "up"     ? scale * 1.125
                         : text == "down" ? scale / 1.125
                                          : number_argument(text, "up, down or a number");
    if (!(asked > 0)) throw InputError("'" + text + "' is not a scale above 0");
    scale = std::clamp(asked, smallest_scale, largest_scale);
}

template <int D>
void tool(Workbench<D>& bench, Text text) {
    const Tool asked = static_cast<Tool>(word_argument(text, tool_words));
    if (D == 3 && edits_scene(asked)) throw InputError("segments are edited in 2D only");
    bench.desk.tool = asked;
    if (edits_scene(asked)) bench.desk.edit = true;
}

template <int D>
void axis(Workbench<D>& bench, Text text) {
    bench.desk.axis = static_cast<TimelineAxis>(word_argument(text, timeline_axis_words));
}

template <int D>
void zoom_timeline(Workbench<D>& bench, Text text) {
    Desk& desk = bench.desk;
    if (text == "all") {
        desk.timeline_from = 0;
        desk.timeline_to = 1;
        return;
    }
    const auto range = parse_steps(text);
    if (!range || (*range)[0] >= (*range)[1]) throw InputError("'" + text + "' is not FROM-TO in steps, or all");
    const auto& [from, to] = *range;
    const double steps = whole_run(bench);
    if (from >= steps)
        throw InputError("step " + std::to_string(from) + " is not before the end of the run at step " +
                         number_text(steps));
    desk.timeline_from = from / steps;
    desk.timeline_to = std::min<double>(to, steps) / steps;
}

template <bool Desk::*flag, int D>
void flip(Workbench<D>& bench, Text) {
    bench.desk.*flag = !(bench.desk.*flag);
}

constexpr std::array tools{NamedArgument{"Select", "select"},        NamedArgument{"Draw wall", "segment"},
                           NamedArgument{"Cut a gap", "gap"},        NamedArgument{"Write text", "text"},
                           NamedArgument{"Draw arrow", "arrow"},     NamedArgument{"Draw ring", "ring"},
                           NamedArgument{"Numbered note", "callout"}};
constexpr std::array scales{NamedArgument{"Larger", "up"}, NamedArgument{"Smaller", "down"},
                            NamedArgument{"Usual size", "1"}};

}  // namespace

template <int D>
std::span<const Command<D>> desk_commands() {
    static constexpr std::array table{
        Command<D>{"scenes", "Open scene", "", "choose a scene from pictures, or by typing a part of its name", "O",
                   flip<&Desk::chooser, D>},
        Command<D>{"show", "Show panel", "PANEL", "show or hide a panel, the timeline or the legend",
                   "1=why 2=code 3=run 4=inversions 5=compare 6=trade-off 7=notes 8=words 9=front Shift+S=settings "
                   "Tab=timeline "
                   "E=legend",
                   show<D>},
        Command<D>{"tool", "Tool",
                   D == 2 ? "select | segment | gap | text | arrow | ring | callout"
                          : "select | text | arrow | ring | callout",
                   "choose what the mouse does in the picture",
                   D == 2 ? "V=select G=segment Shift+G=gap T=text A=arrow R=ring C=callout"
                          : "V=select T=text A=arrow R=ring C=callout",
                   tool<D>, "", tools},
        Command<D>{"axis", "Timeline axis", "steps | primitives", "choose what the timeline counts", "", axis<D>},
        Command<D>{"zoom-timeline", "Timeline range", "FROM-TO | all", "choose which steps the timeline shows", "",
                   zoom_timeline<D>},
        Command<D>{"projector", "Projector", "", "no panels; large text and a banner with the formula", "P",
                   flip<&Desk::projector, D>},
        Command<D>{"fullscreen", "Full screen", "", "let the window cover the whole screen, or give it its size back",
                   "F11 Alt+Enter", flip<&Desk::fullscreen, D>},
        Command<D>{"scale", "Scale", "up | down | N", "make text and controls larger or smaller",
                   "Ctrl+Plus=up Ctrl+Minus=down Ctrl+0=1", scale<D>, "", scales},
        Command<D>{"animate", "Fade steps in", "", "let what a step changes fade in, or show it at once", "",
                   flip<&Desk::animate, D>},
        Command<D>{"console", "Command line", "", "type a command", ": Ctrl+P", flip<&Desk::console, D>},
        Command<D>{"help", "Keys", "", "show all keys and what they do", "F1", flip<&Desk::help, D>},
    };
    return table;
}

template std::span<const Command<2>> desk_commands<2>();
template std::span<const Command<3>> desk_commands<3>();

}  // namespace sightline
