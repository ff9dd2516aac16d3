// Commands that put marks into a session: selection, bookmarks, breakpoints.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/draw/shown_planes.h"
#include "core/run/drawn_levels.h"
#include "core/session/condition.h"
#include "core/session/pixel_history.h"
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

/// NAME, or #N by its number in the panel's data.
template <int D>
std::uint32_t object_argument(const Workbench<D>& bench, Text text) {
    const Objects& objects = bench.session.objects();
    if (const std::uint32_t named = object_named(objects, text); named != none) return named;
    if (text.starts_with('#')) {
        const std::uint32_t number = whole_argument(text.substr(1), "the number of an object");
        if (number < objects.names.size()) return number;
    }
    const std::vector<std::string_view> names(objects.names.begin(), objects.names.end());
    const std::string_view meant = closest(text, names);
    throw InputError("there is no object '" + one_line(text, 60) + "'" +
                     (meant.empty() ? "; the panel Objects lists them" : "; did you mean " + std::string(meant) + "?"));
}

/// Of an object the primitive to look at: the one that misses most pixels, else the one that shows most, else the
/// first.
template <int D>
std::uint32_t primitive_of_object(const Session<D>& session, std::uint32_t object) {
    const Objects& objects = session.objects();
    const Reference& reference = session.reference();
    const std::vector<std::uint8_t> rendered = found_mask(session.traversal());
    std::uint32_t best = none;
    const auto worth = [&](std::uint32_t p) {
        return std::pair(rendered[p] ? 0 : reference.pixels[p], reference.pixels[p]);
    };
    for (std::uint32_t p = 0; p < objects.of.size(); ++p)
        if (objects.of[p] == object && (best == none || worth(p) > worth(best))) best = p;
    return best;
}

/// Of the exact image: what it shows there, or what is drawn there.
std::uint32_t primitive_at_pixel(Workbench<3>& bench, Text text) {
    const auto at = parse_pair(text);
    if (!at) throw InputError("write the column and the row of a pixel of the exact image as X,Y");
    const PixelHistory history = pixel_history(bench.session, static_cast<int>(at->x), static_cast<int>(at->y));
    bench.pixel = {history.x, history.y};
    return history.should_own != none ? history.should_own : history.owns;
}
std::uint32_t primitive_at_pixel(Workbench<2>&, Text) {
    throw InputError("only the exact image of the 3D viewer has pixels to select");
}

/// A segment or a note is selected to be edited, one at a time; the cell or box that is being explained stays
/// meanwhile.
template <int D>
void select(Workbench<D>& bench, Text text) {
    Session<D>& session = bench.session;
    if (text.starts_with("plane:")) return select_plane(bench, text.substr(6));
    std::uint32_t cell = session.selected_cell, node = session.selected_node, primitive = none, note = none;
    bench.pixel.reset();
    if (text.starts_with("primitive:")) {
        primitive = primitive_argument(bench, text.substr(10));
    } else if (text.starts_with("object:")) {
        primitive = primitive_of_object(session, object_argument(bench, text.substr(7)));
    } else if (text.starts_with("pixel:")) {
        primitive = primitive_at_pixel(bench, text.substr(6));
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
    if (text.empty()) throw InputError("write step:N, cell:ID, primitive:ID, object:NAME or an expression");
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
        Command<D>{
            "select", "Select",
            "ID | last | node:ID | node:last | plane:N | primitive:ID | object:NAME | pixel:X,Y | note:N | none",
            "select a cell, a box, one of its planes, a primitive, an object, a pixel of the exact image or a note",
            "J=last", select<D>, "", selectable},
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
