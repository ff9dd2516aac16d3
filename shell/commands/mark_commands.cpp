// Commands that put marks into a session: selection, bookmarks, breakpoints.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.h"
#include "core/draw/shown_planes.h"
#include "core/session/condition.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/moved.h"
#include "shell/desk/moves.h"
#include "shell/desk/undo.h"

namespace sightline {

namespace {

/// Of those between the box and the occluder at hand; the same one again: none.
template <int D>
void select_plane(Workbench<D>& bench, Text text) {
    const std::size_t count = planes_at_hand(bench.session).size();
    const std::uint32_t plane = text == "none" ? none : whole_argument(text, "the number of a plane");
    if (plane != none && count == 0)
        throw InputError("no planes are shown: select a box that was tested, e.g. select node:last");
    if (plane != none && plane >= count)
        throw InputError("there is no plane " + text + "; there are " + std::to_string(count) + ", from 0");
    std::uint32_t& selected = bench.session.selected_plane;
    selected = selected == plane ? none : plane;
}

/// A segment or a note is selected to be edited, one at a time; the cell or box that is being explained stays
/// meanwhile.
template <int D>
void select(Workbench<D>& bench, Text text) {
    Session<D>& session = bench.session;
    if (text.starts_with("plane:")) return select_plane(bench, text.substr(6));
    std::uint32_t cell = session.selected_cell, node = session.selected_node, primitive = none, note = none;
    if (text.starts_with("primitive:")) {
        primitive = primitive_argument(bench, text.substr(10));
    } else if (text.starts_with("note:")) {
        note = note_argument(bench, text.substr(5));
    } else if (text.starts_with("node:")) {
        node = node_argument(bench, text.substr(5));
        cell = none;
    } else {
        cell = text == "none" ? none : cell_argument(bench, text);
        node = none;
    }
    session.selected_cell = cell;
    session.selected_node = node;
    session.selected_plane = none;
    session.selected_primitive = primitive;
    bench.selected_note = note;
    take_along(bench);
}

template <int D>
void bookmark(Workbench<D>& bench, Text text) {
    if (text.empty()) throw InputError("a bookmark needs a label");
    remember(bench);
    bench.session.bookmarks.push_back({bench.session.position(), text});
}

/// CONDITION, or a word for one that depends on where the session stands.
template <int D>
std::string condition_text(const Workbench<D>& bench, Text text) {
    if (text == "selected" || text == "last") return "cell:" + std::to_string(cell_argument(bench, text));
    if (text == "here") return "step:" + std::to_string(bench.session.position());
    if (text.empty()) throw InputError("write step:N, cell:ID or an expression");
    return text;
}

/// Sets a breakpoint, or takes away the one that is there.
template <int D>
void set_breakpoint(Workbench<D>& bench, Text text) {
    auto& breakpoints = bench.session.breakpoints;
    if (text == "none") {
        breakpoints.clear();
        return bench.say("no breakpoints");
    }
    const std::string condition = condition_text(bench, text);
    const auto same = [&](const Breakpoint& b) { return b.condition == condition; };
    if (std::erase_if(breakpoints, same) > 0) return bench.say("breakpoint removed: " + condition);
    condition_for(bench.session, condition);  // throws for what is none
    breakpoints.push_back({condition, true});
    bench.say("breakpoint: " + condition);
}

/// Switches a breakpoint off or on by its number, from 1.
template <int D>
void switch_breakpoint(Workbench<D>& bench, Text text) {
    const std::uint32_t number = whole_argument(text, "the number of a breakpoint");
    auto& breakpoints = bench.session.breakpoints;
    if (number < 1 || number > breakpoints.size())
        throw InputError("there is no breakpoint " + text + "; there are " + std::to_string(breakpoints.size()));
    breakpoints[number - 1].on = !breakpoints[number - 1].on;
}

template <int D>
void mark_all(Workbench<D>& bench, Text text) {
    if (text == "none") {
        bench.marked.clear();
        bench.marked_by.clear();
        return;
    }
    const Condition<D> condition = condition_for(bench.session, condition_text(bench, text));
    bench.marked = matches(bench.record_ahead ? bench.session : at_the_end(bench.session), condition);
    bench.marked_by = condition.text();
    bench.say(std::to_string(bench.marked.size()) + " steps match " + condition.text());
}

constexpr std::array selectable{NamedArgument{"Select last cell", "last"}, NamedArgument{"Select nothing", "none"}};
constexpr std::array stops{NamedArgument{"Break at selection", "selected"}, NamedArgument{"Break here", "here"},
                           NamedArgument{"No breakpoints", "none"}};

}  // namespace

template <int D>
std::span<const Command<D>> mark_commands() {
    static constexpr std::array table{
        Command<D>{"select", "Select", "ID | last | node:ID | node:last | plane:N | primitive:ID | note:N | none",
                   "select a cell, a box, one of its planes, a primitive or a note", "J=last", select<D>, "",
                   selectable},
        Command<D>{"bookmark", "Bookmark", "LABEL", "give this step a name", "B=?", bookmark<D>},
        Command<D>{"break", "Breakpoint", "CONDITION | selected | here | none", "set or remove a breakpoint",
                   "F9=? Shift+F9=selected", set_breakpoint<D>, "", stops},
        Command<D>{"break-switch", "Switch breakpoint", "N", "switch a breakpoint off or on", "", switch_breakpoint<D>},
        Command<D>{"mark", "Mark steps", "CONDITION | none", "mark all matching steps on the timeline", "",
                   mark_all<D>},
    };
    return table;
}

template std::span<const Command<2>> mark_commands<2>();
template std::span<const Command<3>> mark_commands<3>();

}  // namespace sightline
