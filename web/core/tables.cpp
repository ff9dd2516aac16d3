// What stays while one works: commands, menus, methods, scenes.
// SPDX-License-Identifier: GPL-3.0-or-later
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
#include "web/core/json_text.h"
#include "web/core/look.h"

namespace sightline {

namespace {

template <int D>
void put_menu(JsonText& json, const Workbench<D>& bench, const std::vector<MenuRow>& rows) {
    json.array();
    for (const MenuRow& row : rows) {
        json.object();
        if (row.kind == MenuRow::Kind::line) {
            json.member("line", true).end_object();
            continue;
        }
        json.member("label", row.says.label).member("text", row.says.text).member("keys", row.says.keys);
        if (row.kind == MenuRow::Kind::command)
            json.member("command", row.command);
        else
            put_menu(json.name("inside"), bench, rows_inside(bench, row));
        if (row.asks) json.member("asks", true);
        json.end_object();
    }
    json.end_array();
}

template <int D>
void put_commands(JsonText& json) {
    json.name("commands").array();
    for (const CommandGroup<D>& group : command_groups<D>())
        for (const Command<D>& command : group.commands) {
            json.object()
                .member("id", command.id)
                .member("group", group.title)
                .member("label", command.label)
                .member("arguments", command.arguments)
                .member("text", command.text)
                .member("slow", command.slow);
            json.name("keys").array();
            for (const KeyBinding& binding : key_bindings(command.id, command.keys))
                json.object()
                    .member("key", binding.key)
                    .member("command", binding.command)
                    .member("asks", binding.asks)
                    .end_object();
            json.end_array().end_object();
        }
    json.end_array();
}

template <int D>
std::string tables(const Workbench<D>& bench) {
    JsonText json;
    json.object();
    put_commands<D>(json);
    json.name("menus").array();
    for (const Menu& menu : menus<D>()) {
        json.object().member("title", menu.title);
        put_menu(json.name("rows"), bench, menu.rows);
        json.end_object();
    }
    json.end_array().name("panels").array();
    static constexpr std::array bodies{"rows", "widgets", "chart"};
    for (const Panel<D>& panel : panel_table<D>())
        json.object()
            .member("id", panel.id)
            .member("title", panel.title)
            .member("text", panel.text)
            .member("group", panel_group_titles[static_cast<std::size_t>(panel.group)])
            .member("body", bodies[static_cast<std::size_t>(panel.body)])
            .end_object();
    json.end_array().name("methods").array();
    std::vector<std::string> ids;
    for (const Method<D>& method : bench.methods) ids.emplace_back(method.id);
    const std::vector<VariantLook> looks = variant_looks(ids);
    for (std::size_t i = 0; i < bench.methods.size(); ++i) {
        const Method<D>& method = bench.methods[i];
        json.object()
            .member("id", method.id)
            .member("title", method.title)
            .member("sentence", method.sentence)
            .member("colour", hex_colour(looks[i].colour))
            .end_object();
    }
    json.end_array().name("presets").array();
    for (const Preset& preset : presets())
        json.object().member("id", preset.id).member("title", preset.title).end_object();
    return json.end_array().end_object().take();
}

void add(JsonText& json, std::string_view group, std::string_view title, std::string_view text,
         const std::string& command, int dimension) {
    json.object()
        .member("group", group)
        .member("title", title)
        .member("text", text)
        .member("command", command)
        .member("dimension", dimension)
        .end_object();
}

template <int D>
void add_rows(JsonText& list, std::span<const CatalogueRow<D>> rows, const std::string& group) {
    for (const CatalogueRow<D>& row : rows) {
        const std::string size = D == 3 && row.triangles > 100'000 ? ":50k" : "";
        add(list, group, row.title, row.lesson, "open " + std::string(row.id) + size, D);
    }
}

}  // namespace

std::string tables_json(Page& page) {
    return with_bench(page, [&](auto& on) { return tables(on.bench); });
}

std::string scenes_json() {
    JsonText list;
    list.array();
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
    return list.end_array().take();
}

}  // namespace sightline
