// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/menus.h"

#include <algorithm>
#include <initializer_list>

#include "shell/commands/arguments.h"
#include "shell/commands/command_table.h"
#include "shell/commands/key_bindings.h"
#include "shell/panels/panel.h"

namespace sightline {

namespace {

using RowKind = MenuRow::Kind;

/// "show why" has the title of the panel.
template <int D>
std::string panel_title(const std::string& id) {
    if (id == "timeline") return "Timeline";
    if (id == "legend") return "Legend";
    const Panel<D>* const panel = find_panel<D>(id);
    return panel ? std::string(panel->title) + " panel" : "";
}

template <int D>
std::string label_of(const Command<D>& command, const std::string& argument) {
    if (argument.empty()) return std::string(command.label);
    if (command.id == "show") return panel_title<D>(argument);
    for (const NamedArgument& named : command.named)
        if (named.argument == argument) return std::string(named.label);
    return "";
}

template <int D>
MenuRow row_with_menu(std::string_view title);

/// "-" is a line, "open ?" asks, "<Panels>" opens another menu; "2D: …" and "3D: …" are for one viewer only.
template <int D>
std::vector<MenuRow> menu_rows(std::initializer_list<std::string_view> texts) {
    std::vector<MenuRow> all;
    for (std::string_view text : texts) {
        if (text.starts_with(D == 2 ? "3D: " : "2D: ")) continue;
        if (text.starts_with(D == 2 ? "2D: " : "3D: ")) text.remove_prefix(4);
        MenuRow row;
        row.command = text;
        if (text == "-") row.kind = RowKind::line;
        if (text.starts_with('<')) row = row_with_menu<D>(text.substr(1, text.size() - 2));
        row.asks = text.ends_with(" ?");
        if (row.asks) row.command.resize(row.command.size() - 2);
        if (row.kind == RowKind::command) row.says = spoken<D>(row.command);
        all.push_back(std::move(row));
    }
    return all;
}

template <int D>
MenuRow row_with_menu(std::string_view title) {
    MenuRow row{RowKind::menu, "", false, {std::string(title), "", ""}};
    if (title == "Recent scenes") row.kind = RowKind::recent;
    if (title == "Method") row.kind = RowKind::methods;
    if (title == "Panels") row.kind = RowKind::panels;
    if (title == "Export data") row.inside = menu_rows<D>({"cells ?", "trace ?", "stats ?", "panels ?"});
    if (title == "By viewpoint")
        row.inside = menu_rows<D>(
            {"method by-viewpoint", "show viewpoint", "viewpoint next", "work-out region", "work-out all"});
    if (title == "Picture")
        row.inside = menu_rows<D>({"cycle heat", "cycle label", "cycle show_normals", "cycle show_penalties",
                                   "cycle show_chain", "cycle show_planes", "cycle show_regions", "cycle palette",
                                   "3D: cycle triangles", "3D: cycle only", "3D: cycle slice"});
    return row;
}

template <int D>
std::vector<Menu> make_menus() {
    std::vector<Menu> all{
        {"File",
         menu_rows<D>({"scenes", "open ?", "<Recent scenes>", "-", "save ?", "shot ?", "size ?", "film ?", "page ?",
                       "<Export data>", "-", "copy", "paste", "2D: viewer3d", "3D: viewer2d", "-", "quit"})},
        {"Edit", menu_rows<D>({"undo", "redo", "-", "2D: edit", "2D: tool segment", "2D: tool gap", "2D: scene new",
                               "2D: scene save ?", "2D: -", "tool select", "tool text", "tool arrow", "tool ring",
                               "tool callout", "delete", "-", "bookmark ?", "mark ?"})},
        {"View", menu_rows<D>({"fit",
                               "fit selected",
                               "look selected",
                               "zoom 1.25",
                               "zoom 0.8",
                               "2D: eye-strip",
                               "3D: cycle split",
                               "3D: cycle inset",
                               "-",
                               "freeze",
                               "unfreeze",
                               "3D: through",
                               "-",
                               "show timeline",
                               "show legend",
                               "<Panels>",
                               "<Picture>",
                               "-",
                               "scale up",
                               "scale down",
                               "scale 1",
                               "-",
                               "animate",
                               "projector",
                               "fullscreen"})},
        {"Run", menu_rows<D>({"step",
                              "back",
                              "into",
                              "out",
                              "-",
                              "seek start",
                              "run",
                              "toggle",
                              "play 20s",
                              "speed half",
                              "speed double",
                              "-",
                              "until ?",
                              "reach selected",
                              "continue",
                              "break ?",
                              "-",
                              "missed 1",
                              "-",
                              "<Method>",
                              "cycle penalty",
                              "budget ?",
                              "complete",
                              "<By viewpoint>"})},
        {"Compare",
         menu_rows<D>({"compare penalty", "compare distance", "compare perfect order", "compare view only", "compare ?",
                       "-", "difference", "swap", "align step", "align drawn", "compare off", "-", "show trade-off"})},
        {"Lesson", menu_rows<D>({"lesson", "next", "previous", "truth", "answer ?", "speaker", "lesson end"})},
        {"Help", menu_rows<D>({"help", "show words", "show techniques", "console", "-", "show why", "what-if"})},
    };
    all.insert(all.begin() + 4,
               Menu{D == 3 ? "Fly" : "Path",
                    menu_rows<D>({"3D: fly", "path", "path toggle", "path step", "path back", "path start", "path loop",
                                  "path record", "path save ?", "3D: -", "3D: fly-speed x2", "3D: fly-speed x0.5"})});
    return all;
}

}  // namespace

template <int D>
SpokenCommand spoken(std::string_view text) {
    const auto [id, argument] = split_word(std::string(text));
    SpokenCommand says;
    for (const Command<D>& command : command_table<D>()) {
        if (command.id != id) continue;
        says = {label_of(command, argument), std::string(command.text), ""};
        if (says.label.empty()) says.label = command.label;  // one that asks for the rest: "path save"
        for (const KeyBinding& binding : key_bindings(command.id, command.keys))
            if (binding.command == text) says.keys += (says.keys.empty() ? "" : ", ") + binding.key;
    }
    return says;
}

template <int D>
const std::vector<Menu>& menus() {
    static const std::vector<Menu> all = make_menus<D>();
    return all;
}

template <int D>
std::vector<MenuRow> rows_inside(const Workbench<D>& bench, const MenuRow& row) {
    const RowKind kind = row.kind;
    std::vector<MenuRow> all = row.inside;
    const auto add = [&](const std::string& command, const std::string& label, std::string_view text) {
        all.push_back({RowKind::command, command, false, {label, std::string(text), spoken<D>(command).keys}});
    };
    if (kind == RowKind::recent)
        for (const std::string& name : bench.recent) add("open \"" + name + "\"", name, "open it again");
    if (kind == RowKind::methods)
        for (const Method<D>& method : bench.methods)
            add("method " + std::string(method.id), std::string(method.title), method.sentence);
    if (kind == RowKind::panels)
        for (const Panel<D>& panel : panel_table<D>())
            add("show " + std::string(panel.id), std::string(panel.title), panel.text);
    return all;
}

template SpokenCommand spoken<2>(std::string_view);
template SpokenCommand spoken<3>(std::string_view);
template const std::vector<Menu>& menus<2>();
template const std::vector<Menu>& menus<3>();
template std::vector<MenuRow> rows_inside<2>(const Workbench<2>&, const MenuRow&);
template std::vector<MenuRow> rows_inside<3>(const Workbench<3>&, const MenuRow&);

}  // namespace sightline
