// The settings panel: a widget per row of the settings table, grouped by what a change makes again, and the presets.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "shell/commands/command_table.h"
#include "shell/window/button_row.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

constexpr std::array group_titles{"Picture", "Reference", "Traversal", "Tessellation", "Scene"};

void tip(const SettingRow& row) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(30 * ImGui::GetFontSize());
    ImGui::TextUnformatted(std::string(row.help).c_str());
    ImGui::TextDisabled("%s; default %s; source: %s", std::string(row.values).c_str(), row.get({}).c_str(),
                        std::string(row.source).c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void choose(Ui& ui, const std::string& name, const std::string& value, std::span<const std::string_view> words) {
    if (!ImGui::BeginCombo("##value", value.c_str())) return;
    for (const std::string_view word : words)
        if (ImGui::Selectable(std::string(word).c_str(), word == value))
            ui.act("set " + name + "=" + std::string(word));
    ImGui::EndCombo();
}

template <int D>
void widget(Ui& ui, const Workbench<D>& bench, const SettingRow& row) {
    const std::string name(row.name), value = row.get(bench.session.settings());
    if (name == "method") {
        std::vector<std::string_view> ids;
        for (const Method<D>& method : bench.methods) ids.push_back(method.id);
        return choose(ui, name, value, ids);
    }
    if (std::ranges::equal(row.words, words<Switch>)) {
        bool on = value == "on";
        if (ImGui::Checkbox("##value", &on)) ui.act("set " + name + (on ? "=on" : "=off"));
        return;
    }
    if (!row.words.empty()) return choose(ui, name, value, row.words);
    std::string text = value;
    if (ImGui::InputText("##value", &text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
        ui.act(quote_command("set " + name + "=" + text));  // a list has semicolons
}

}  // namespace

template <int D>
void settings_widgets(Ui& ui, Workbench<D>& bench) {
    ImGui::TextDisabled("presets");
    ButtonRow row(ImGui::GetStyle().ItemSpacing.x);
    for (const Preset& preset : presets()) {
        if (row.add(std::string(preset.id), false)) ui.act("preset " + std::string(preset.id));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(preset.title).c_str());
    }
    for (const Invalidates group : {Invalidates::traversal, Invalidates::picture, Invalidates::tessellation,
                                    Invalidates::reference, Invalidates::scene}) {
        const char* const title = group_titles[static_cast<std::size_t>(group)];
        if (!ImGui::CollapsingHeader(title, group >= Invalidates::tessellation || group == Invalidates::reference
                                                ? 0
                                                : ImGuiTreeNodeFlags_DefaultOpen))
            continue;
        for (const SettingRow& row : settings_table()) {
            if (row.invalidates != group || !applies<D>(row, bench.session.method())) continue;
            const std::string name(row.name);
            ImGui::PushID(name.c_str());
            ImGui::AlignTextToFramePadding();
            const bool changed = row.get(bench.session.settings()) != row.get({});
            ImGui::PushFont(changed ? ui.fonts.bold : ui.fonts.text);
            ImGui::TextUnformatted(name.c_str());
            ImGui::PopFont();
            tip(row);
            ImGui::SameLine(std::max(12.5f * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x * 0.6f));
            ImGui::SetNextItemWidth(-1);
            widget(ui, bench, row);
            tip(row);
            note_place(bench, "setting " + name);
            ImGui::PopID();
        }
    }
}

template void settings_widgets<2>(Ui&, Workbench<2>&);
template void settings_widgets<3>(Ui&, Workbench<3>&);

}  // namespace sightline
