// What stays while one works: commands, menus, methods, scenes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/draw/variant_look.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/session/settings_table.h"
#include "shell/commands/command_table.h"
#include "shell/commands/key_bindings.h"
#include "shell/commands/menus.h"
#include "shell/panels/panel_table.h"
#include "web/core/look.h"

namespace sightline {

namespace {

using List = nlohmann::ordered_json;

template <int D>
List menu_json(const Workbench<D>& bench, const std::vector<MenuRow>& rows) {
    List list = List::array();
    for (const MenuRow& row : rows) {
        if (row.kind == MenuRow::Kind::line) {
            list.push_back({{"line", true}});
            continue;
        }
        List one{{"label", row.says.label}, {"text", row.says.text}, {"keys", row.says.keys}};
        if (row.kind == MenuRow::Kind::command)
            one["command"] = row.command;
        else
            one["inside"] = menu_json(bench, rows_inside(bench, row));
        if (row.asks) one["asks"] = true;
        list.push_back(std::move(one));
    }
    return list;
}

template <int D>
List tables(const Workbench<D>& bench) {
    List json;
    for (const CommandGroup<D>& group : command_groups<D>())
        for (const Command<D>& command : group.commands) {
            List one{{"id", command.id},       {"group", group.title},
                     {"label", command.label}, {"arguments", command.arguments},
                     {"text", command.text},   {"slow", command.slow}};
            for (const KeyBinding& binding : key_bindings(command.id, command.keys))
                one["keys"].push_back({{"key", binding.key}, {"command", binding.command}, {"asks", binding.asks}});
            json["commands"].push_back(std::move(one));
        }
    for (const Menu& menu : menus<D>())
        json["menus"].push_back({{"title", menu.title}, {"rows", menu_json(bench, menu.rows)}});
    static constexpr std::array bodies{"rows", "widgets", "chart"};
    for (const Panel<D>& panel : panel_table<D>())
        json["panels"].push_back({{"id", panel.id},
                                  {"title", panel.title},
                                  {"text", panel.text},
                                  {"group", panel_group_titles[static_cast<std::size_t>(panel.group)]},
                                  {"body", bodies[static_cast<std::size_t>(panel.body)]}});
    std::vector<std::string> ids;
    for (const Method<D>& method : bench.methods) ids.emplace_back(method.id);
    const std::vector<VariantLook> looks = variant_looks(ids);
    for (std::size_t i = 0; i < bench.methods.size(); ++i) {
        const Method<D>& method = bench.methods[i];
        json["methods"].push_back({{"id", method.id},
                                   {"title", method.title},
                                   {"sentence", method.sentence},
                                   {"colour", hex_colour(looks[i].colour)}});
    }
    for (const Preset& preset : presets()) json["presets"].push_back({{"id", preset.id}, {"title", preset.title}});
    return json;
}

void add(List& list, const std::string& group, const std::string& title, const std::string& text,
         const std::string& command, int dimension) {
    list.push_back(
        {{"group", group}, {"title", title}, {"text", text}, {"command", command}, {"dimension", dimension}});
}

template <int D>
void add_rows(List& list, std::span<const CatalogueRow<D>> rows, const std::string& group) {
    for (const CatalogueRow<D>& row : rows) {
        const std::string size = D == 3 && row.triangles > 100'000 ? ":50k" : "";
        add(list, group, row.title, row.lesson, "open " + std::string(row.id) + size, D);
    }
}

}  // namespace

std::string tables_json(Page& page) {
    return with_bench(page,
                      [&](auto& on) { return tables(on.bench).dump(-1, ' ', false, List::error_handler_t::replace); });
}

std::string scenes_json() {
    List list = List::array();
    add_rows(list, catalogue<2>(), "Scenes");
    for (const Lesson& lesson : read_lessons(lessons_of_the_project()))
        add(list, "Lessons", lesson.title,
            counted(lesson.parts.size(), "part") + ", " +
                counted(static_cast<std::size_t>(lesson.minutes()), "minute") + ": " + lesson.parts.front().title +
                " …",
            "lesson " + lesson.id, lesson.dimension);
    add_rows(list, catalogue<3>(), "Scenes in three dimensions");
    add_rows(list, failure_scenes<2>(), "Where methods fail");
    add_rows(list, failure_scenes<3>(), "Where methods fail, in three dimensions");
    for (const std::string& map : installed_maps())
        add(list, "Doom levels", map, "A level of Freedoom.", "open " + map, 2);
    return list.dump(-1, ' ', false, List::error_handler_t::replace);
}

}  // namespace sightline
