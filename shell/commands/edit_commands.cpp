// Commands that edit the scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "shell/commands/arguments.h"
#include "shell/commands/groups.h"
#include "shell/desk/edit.h"
#include "shell/desk/notes.h"

namespace sightline {

namespace {

Primitive<2> parse_segment(Text text, const Scene<2>& scene) {
    const auto [first, second] = split_word(text);
    if (first.empty() || second.empty()) throw InputError("write the ends of the segment as X,Y X,Y");
    return {parse_point(first, scene), parse_point(second, scene)};
}

void edit_segment(Workbench<2>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"add", "move", "delete", "cut"});
    const auto [what, rest] = split_word(text);
    const std::size_t word = word_argument(what, words);
    const Scene<2>& scene = bench.session.scene();
    if (word == 0) return add_segment(bench, parse_segment(rest, scene));
    const auto [id, ends] = split_word(rest);
    const std::uint32_t index = primitive_argument(bench, id.empty() ? "selected" : id);
    if (word == 1) return move_segment(bench, index, parse_segment(ends, scene));
    if (word == 3) {
        const auto [from, to] = parse_segment(ends, scene);
        return cut_gap(bench, bench.session.shared_scene(), index, from, to);
    }
    if (!ends.empty()) throw InputError("unexpected '" + ends + "'");
    delete_segment(bench, index);
}

void delete_selected(Workbench<2>& bench, Text) {
    if (bench.selected_note < bench.session.notes.size()) return delete_note(bench, bench.selected_note);
    delete_segment(bench, primitive_argument(bench, "selected"));
}

void edit_scene(Workbench<2>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"new", "save"});
    const auto [what, file] = split_word(text);
    if (word_argument(what, words) == 0) return new_scene(bench);
    save_scene(bench, file_argument(file));
    bench.say("wrote " + file);
}

/// Without its tools: they would go on changing the scene.
void edit(Workbench<2>& bench, Text text) {
    constexpr auto words = std::to_array<std::string_view>({"off", "on"});
    Desk& desk = bench.desk;
    desk.edit = text.empty() ? !desk.edit : word_argument(text, words) == 1;
    if (!desk.edit && edits_scene(desk.tool)) desk.tool = Tool::select;
    bench.say(desk.edit ? "edit mode: drag a wall, its ends, or the handles of the view; G draws a wall, Shift+G cuts "
                          "a gap, Delete removes, W ends this"
                        : "edit mode is off: walls stay where they are");
}

constexpr std::array scene_files{NamedArgument{"New scene", "new"}};

}  // namespace

template <>
std::span<const Command<2>> edit_commands<2>() {
    static constexpr std::array table{
        Command<2>{"edit", "Edit walls", "[on | off]",
                   "give walls and the view handles to drag, or take them away so that nothing moves by accident", "W",
                   edit},
        Command<2>{
            "segment", "Edit segment", "add X,Y X,Y | move ID X,Y X,Y | cut ID X,Y X,Y | delete [ID]",
            "add, move, cut or delete a segment; cut removes what lies between two points; ID is a number or selected",
            "", edit_segment},
        Command<2>{"delete", "Delete", "", "delete the selected note or segment", "Delete", delete_selected},
        Command<2>{"scene", "Scene file", "new | save FILE", "start an empty scene, or save this one", "Ctrl+N=new",
                   edit_scene, "", scene_files},
    };
    return table;
}

/// Scenes in 3D are not edited; notes are.
template <>
std::span<const Command<3>> edit_commands<3>() {
    static constexpr std::array table{
        Command<3>{"delete", "Delete", "", "delete the selected note", "Delete",
                   [](Workbench<3>& bench, Text) { delete_note(bench, note_argument(bench, "selected")); }},
    };
    return table;
}

}  // namespace sightline
