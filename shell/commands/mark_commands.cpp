// Commands that put marks into a session: selection, bookmarks, breakpoints, notes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/error.h"
#include "core/number.h"
#include "core/session/condition.h"
#include "shell/bench/history.h"
#include "shell/bench/moves.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"

namespace sightline {

namespace {

template <int D>
void select(Workbench<D>& bench, Text text) {
    std::uint32_t cell = none, primitive = none;
    if (text.starts_with("primitive:"))
        primitive = primitive_argument(bench, text.substr(10));
    else if (text != "none")
        cell = cell_argument(bench, text);
    bench.session.selected_cell = cell;
    bench.session.selected_primitive = primitive;
}

template <int D>
void bookmark(Workbench<D>& bench, Text text) {
    if (text.empty()) throw InputError("a bookmark needs a label");
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
    if (std::erase_if(breakpoints, same) > 0) return bench.say("breakpoint taken away: " + condition);
    Condition<D>{condition};  // throws for what is none
    breakpoints.push_back({condition, true});
    bench.say("breakpoint: " + condition);
}

/// Switches a breakpoint off or on by its number, from 1.
template <int D>
void switch_breakpoint(Workbench<D>& bench, Text text) {
    const std::uint32_t number = whole_argument(text, "the number of a breakpoint");
    auto& breakpoints = bench.session.breakpoints;
    if (number < 1 || number > breakpoints.size())
        throw InputError("there is no breakpoint " + text + ", only " + std::to_string(breakpoints.size()));
    breakpoints[number - 1].on = !breakpoints[number - 1].on;
}

template <int D>
void mark_all(Workbench<D>& bench, Text text) {
    bench.marked.clear();
    bench.marked_by.clear();
    if (text == "none") return;
    const Condition<D> condition(condition_text(bench, text));
    bench.marked = matches(bench.record_ahead ? bench.session : at_the_end(bench.session), condition);
    bench.marked_by = condition.text();
    bench.say(std::to_string(bench.marked.size()) + " steps match " + condition.text());
}

/// "[DX,DY] words" -> the offset, and words without it.
std::optional<Vec<2>> take_offset(std::string& words) {
    if (!words.starts_with('[')) return std::nullopt;
    const std::size_t end = words.find(']'), comma = words.find(',');
    const std::string_view view = words;
    const auto x = end == std::string::npos || comma > end ? std::nullopt : parse_number(view.substr(1, comma - 1));
    const auto y = !x ? std::nullopt : parse_number(view.substr(comma + 1, end - comma - 1));
    if (!x || !y) throw InputError("write the offset in points as [DX,DY]");
    const std::size_t start = words.find_first_not_of(' ', end + 1);
    words = start == std::string::npos ? "" : words.substr(start);
    return Vec<2>{*x, *y};
}

/// "{FROM-TO} words" -> the steps in which a note shows, and words without them.
std::optional<std::array<std::uint32_t, 2>> take_steps(std::string& words) {
    if (!words.starts_with('{')) return std::nullopt;
    const std::size_t end = words.find('}'), dash = words.find('-');
    const std::string_view view = words;
    if (end == std::string::npos || dash > end) throw InputError("write the steps of a note as {FROM-TO} or {FROM-}");
    const auto first = parse_whole(view.substr(1, dash - 1));
    const std::string_view to = view.substr(dash + 1, end - dash - 1);
    const auto last = to.empty() ? std::optional(none) : parse_whole(to);
    if (!first || !last) throw InputError("write the steps of a note as {FROM-TO} or {FROM-}");
    const std::size_t start = words.find_first_not_of(' ', end + 1);
    words = start == std::string::npos ? "" : words.substr(start);
    return std::array{*first, *last};
}

/// KIND ANCHOR [DX,DY] {FROM-TO} TEXT, with ANCHOR X,Y, cell:ID or primitive:ID.
template <int D>
void note(Workbench<D>& bench, Text text) {
    Note<D> note;
    const auto [kind, rest] = split_word(text);
    note.kind = static_cast<typename Note<D>::Kind>(word_argument(kind, note_kind_words));
    auto [anchor, words] = split_word(rest);
    if (anchor.starts_with("cell:")) {
        note.anchor = Note<D>::Anchor::cell;
        note.index = cell_argument(bench, anchor.substr(5));
    } else if (anchor.starts_with("primitive:")) {
        note.anchor = Note<D>::Anchor::primitive;
        note.index = primitive_argument(bench, anchor.substr(10));
    } else {
        note.point = parse_point(anchor, bench.session.scene());
    }
    if (const auto offset = take_offset(words)) note.offset_pt = *offset;
    if (const auto steps = take_steps(words)) std::tie(note.first_step, note.last_step) = std::tuple_cat(*steps);
    note.text = words;
    if (note.kind == Note<D>::Kind::callout)
        for (const Note<D>& other : bench.session.notes) note.number = std::max(note.number, other.number);
    note.number += note.kind == Note<D>::Kind::callout;
    remember(bench);
    bench.session.notes.push_back(note);
}

/// N TEXT | N delete | N steps FROM-TO, with N from 1.
template <int D>
void edit_note(Workbench<D>& bench, Text text) {
    const auto [number, what] = split_word(text);
    const std::uint32_t n = whole_argument(number, "the number of a note");
    if (n < 1 || n > bench.session.notes.size())
        throw InputError("there is no note " + number + ", only " + std::to_string(bench.session.notes.size()));
    std::string words = what;
    const auto steps = take_steps(words);
    if (words.empty() && !steps) throw InputError("write the new text, {FROM-TO}, or delete");
    remember(bench);
    auto& notes = bench.session.notes;
    if (words == "delete") {
        notes.erase(notes.begin() + (n - 1));
        return;
    }
    if (steps) std::tie(notes[n - 1].first_step, notes[n - 1].last_step) = std::tuple_cat(*steps);
    if (!words.empty()) notes[n - 1].text = words;
}

}  // namespace

template <int D>
std::span<const Command<D>> mark_commands() {
    static constexpr std::array table{
        Command<D>{"select", "ID | last | primitive:ID | none", "select a cell or a primitive", "J=last", select<D>},
        Command<D>{"bookmark", "LABEL", "name this step", "B=?", bookmark<D>},
        Command<D>{"break", "CONDITION | selected | here | none", "set a breakpoint, or take it away",
                   "F9=? Shift+F9=selected", set_breakpoint<D>},
        Command<D>{"break-switch", "N", "switch a breakpoint off or on", "", switch_breakpoint<D>},
        Command<D>{"mark", "CONDITION | none", "mark every step that matches on the timeline", "", mark_all<D>},
        Command<D>{"note", "KIND ANCHOR [[DX,DY]] [{FROM-TO}] TEXT",
                   "text, arrow, ring or callout at X,Y, cell:ID, cell:last or primitive:ID, text shifted in points, "
                   "shown in these steps",
                   "", note<D>},
        Command<D>{"note-edit", "N TEXT | N {FROM-TO} | N delete", "change or delete the note of this number", "",
                   edit_note<D>},
    };
    return table;
}

template std::span<const Command<2>> mark_commands<2>();

}  // namespace sightline
