// Commands about notes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "core/base/error.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/moved.h"
#include "shell/desk/notes.h"
#include "shell/desk/undo.h"

namespace sightline {

namespace {

/// "[what] words" -> what, and words without it; nothing where the bracket is not closed.
std::optional<std::string> take_bracket(std::string& words, char closing) {
    const std::size_t end = words.find(closing);
    if (end == std::string::npos) return std::nullopt;
    const std::string what = words.substr(1, end - 1);
    const std::size_t start = words.find_first_not_of(' ', end + 1);
    words = start == std::string::npos ? "" : words.substr(start);
    return what;
}

/// "[DX,DY] words" -> the offset, and words without it.
std::optional<Vec<2>> take_offset(std::string& words) {
    if (!words.starts_with('[')) return std::nullopt;
    const auto what = take_bracket(words, ']');
    const auto offset = what ? parse_pair(*what) : std::nullopt;
    if (!offset) throw InputError("write the offset in points as [DX,DY]");
    return offset;
}

/// "{FROM-TO} words" -> the steps in which a note shows, and words without them.
std::optional<std::array<std::uint32_t, 2>> take_steps(std::string& words) {
    if (!words.starts_with('{')) return std::nullopt;
    const auto what = take_bracket(words, '}');
    if (what && what->ends_with('-'))
        return std::array{whole_argument(what->substr(0, what->size() - 1), "the first step of a note"), none};
    const auto steps = what ? parse_steps(*what) : std::nullopt;
    if (!steps) throw InputError("write the steps of a note as {FROM-TO} or {FROM-}");
    return steps;
}

/// X,Y, cell:ID or primitive:ID.
template <int D>
void set_anchor(const Workbench<D>& bench, Note<D>& note, Text anchor) {
    using Anchor = typename Note<D>::Anchor;
    if (anchor.starts_with("cell:")) {
        note.anchor = Anchor::cell;
        note.index = cell_argument(bench, anchor.substr(5));
    } else if (anchor.starts_with("primitive:")) {
        note.anchor = Anchor::primitive;
        note.index = primitive_argument(bench, anchor.substr(10));
    } else {
        note.anchor = Anchor::point;
        note.point = parse_point(anchor, bench.session.scene());
    }
}

/// KIND ANCHOR [DX,DY] {FROM-TO} TEXT
template <int D>
void note(Workbench<D>& bench, Text text) {
    Note<D> note;
    const auto [kind, rest] = split_word(text);
    note.kind = static_cast<typename Note<D>::Kind>(word_argument(kind, note_kind_words));
    auto [anchor, words] = split_word(rest);
    set_anchor(bench, note, anchor);
    if (note.kind == Note<D>::Kind::callout) note.offset_pt = {0, 0};
    if (const auto offset = take_offset(words)) note.offset_pt = *offset;
    if (const auto steps = take_steps(words)) std::tie(note.first_step, note.last_step) = std::tuple_cat(*steps);
    note.text = words;
    if (note.kind == Note<D>::Kind::callout)
        for (const Note<D>& other : bench.session.notes) note.number = std::max(note.number, other.number);
    note.number += note.kind == Note<D>::Kind::callout;
    remember(bench);
    bench.session.notes.push_back(note);
    take_along(bench);
}

/// N delete, N at ANCHOR, or N [DX,DY] {FROM-TO} TEXT, any of these; N from 1, or selected.
template <int D>
void edit_note(Workbench<D>& bench, Text text) {
    const auto [number, what] = split_word(text);
    const std::uint32_t index = note_argument(bench, number);
    auto& notes = bench.session.notes;
    Note<D> note = notes[index];
    std::string words = what;
    if (words == "delete") return delete_note(bench, index);
    if (words.starts_with("at ")) {
        set_anchor(bench, note, words.substr(3));
    } else {
        const auto offset = take_offset(words);
        const auto steps = take_steps(words);
        if (words.empty() && !steps && !offset)
            throw InputError("write the new text, [DX,DY], {FROM-TO}, at ANCHOR, or delete");
        if (offset) note.offset_pt = *offset;
        if (steps) std::tie(note.first_step, note.last_step) = std::tuple_cat(*steps);
        if (!words.empty()) note.text = words;
    }
    remember(bench);
    notes[index] = note;
    take_along(bench);
}

}  // namespace

template <int D>
std::span<const Command<D>> note_commands() {
    static constexpr std::array table{
        Command<D>{
            "note", "Add note", "KIND ANCHOR [[DX,DY]] [{FROM-TO}] TEXT",
            "add a text, arrow, ring or callout at X,Y, cell:ID, cell:last or primitive:ID; DX,DY moves its text or "
            "number, in points; FROM-TO are the steps that show it",
            "", note<D>},
        Command<D>{"note-edit", "Edit note", "N TEXT | N [DX,DY] | N {FROM-TO} | N at ANCHOR | N delete",
                   "change, move or delete note N (its number, or selected)", "", edit_note<D>},
    };
    return table;
}

template std::span<const Command<2>> note_commands<2>();
template std::span<const Command<3>> note_commands<3>();

}  // namespace sightline
