// The command table as menus.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/command_table.h"
#include "shell/commands/prompt.h"
#include "shell/window/keys.h"
#include "shell/window/parts.h"

namespace sightline {

namespace {

/// "Right, PageDown"
std::string keys_of(std::string_view id, std::string_view keys) {
    std::string text;
    for (const KeyBinding& binding : key_bindings(id, keys))
        if (binding.command == id) text += (text.empty() ? "" : ", ") + binding.key;
    return text;
}

}  // namespace

template <int D>
float menu_bar(Ui& ui, Workbench<D>& bench) {
    if (!ImGui::BeginMainMenuBar()) return 0;
    const float height = ImGui::GetWindowHeight();
    for (const CommandGroup<D>& group : command_groups<D>()) {
        const std::string title(group.title);
        const bool open = ImGui::BeginMenu(title.c_str());
        note_place(bench, "menu " + title);
        if (!open) continue;
        for (const Command<D>& command : group.commands) {
            ImGui::PushFont(ui.fonts.bold);
            for (const MenuEntry& entry : command.entries)
                if (ImGui::MenuItem(std::string(entry.label).c_str()))
                    ui.act(std::string(command.id) + " " + std::string(entry.argument));
            ImGui::PopFont();
            const bool needs = !command.arguments.empty() && !command.arguments.starts_with('[');
            const std::string label = std::string(command.label) + (needs ? " …" : "");
            ImGui::PushFont(ui.fonts.bold);
            const bool chosen = ImGui::MenuItem(label.c_str(), keys_of(command.id, command.keys).c_str());
            ImGui::PopFont();
            if (chosen) {
                if (needs)
                    ask(bench, std::string(command.id));
                else
                    ui.act(std::string(command.id));
            }
            if (ImGui::IsItemHovered())
                ImGui::SetTooltip("%s %s", std::string(command.id).c_str(), std::string(command.arguments).c_str());
            ImGui::TextDisabled("  %s", std::string(command.text).c_str());
        }
        if (title == "File" && !bench.recent.empty()) {
            ImGui::Separator();
            std::string chosen;
            for (const std::string& name : bench.recent)
                if (ImGui::MenuItem(name.c_str())) chosen = name;
            if (!chosen.empty()) ui.act("open \"" + chosen + "\"");  // changes the list
        }
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
    return height;
}

template float menu_bar<2>(Ui&, Workbench<2>&);
template float menu_bar<3>(Ui&, Workbench<3>&);

}  // namespace sightline
