// The menus.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "shell/commands/menus.h"
#include "shell/commands/prompt.h"
#include "shell/window/parts.h"

namespace sightline {

namespace {

/// What is chosen runs when the menu is done: it may change what the rows are made of.
template <int D>
void draw_menu(const Workbench<D>& bench, const std::vector<MenuRow>& rows, std::optional<MenuRow>& chosen,
               float unit) {
    for (const MenuRow& row : rows) {
        if (row.kind == MenuRow::Kind::line) {
            ImGui::Separator();
            continue;
        }
        if (row.kind != MenuRow::Kind::command) {
            const std::vector<MenuRow> inside = rows_inside(bench, row);
            if (!ImGui::BeginMenu(row.says.label.c_str(), !inside.empty())) continue;
            draw_menu(bench, inside, chosen, unit);
            ImGui::EndMenu();
            continue;
        }
        if (ImGui::MenuItem(row.says.label.c_str(), row.says.keys.c_str())) chosen = row;
        if (!ImGui::IsItemHovered()) continue;
        // Beside the menu, not over its rows.
        const ImVec2 menu = ImGui::GetWindowPos();
        ImGui::SetNextWindowPos({menu.x + ImGui::GetWindowWidth() + 3 * unit, ImGui::GetItemRectMin().y});
        ImGui::SetTooltip("%s", row.says.text.c_str());
    }
}

}  // namespace

template <int D>
float menu_bar(Ui& ui, Workbench<D>& bench) {
    if (!ImGui::BeginMainMenuBar()) return 0;
    const float height = ImGui::GetWindowHeight();
    std::optional<MenuRow> chosen;
    for (const Menu& menu : menus<D>()) {
        const std::string title(menu.title);
        const bool open = ImGui::BeginMenu(title.c_str());
        note_place(bench, "menu " + title);
        if (!open) continue;
        draw_menu(bench, menu.rows, chosen, ui.unit);
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
    if (chosen) chosen->asks ? ask(bench, chosen->command) : ui.act(chosen->command);
    return height;
}

template float menu_bar<2>(Ui&, Workbench<2>&);
template float menu_bar<3>(Ui&, Workbench<3>&);

}  // namespace sightline
