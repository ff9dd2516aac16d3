// All keys with what they do, from the command table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "shell/commands/command_table.h"
#include "shell/commands/key_bindings.h"
#include "shell/commands/menus.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

struct HelpLine {
    std::string key;  ///< empty: a heading
    std::string text;
};

template <int D>
std::vector<HelpLine> help_lines() {
    std::vector<HelpLine> lines;
    for (const CommandGroup<D>& group : command_groups<D>()) {
        lines.push_back({"", std::string(group.title)});
        for (const Command<D>& command : group.commands)
            for (const KeyBinding& binding : key_bindings(command.id, command.keys)) {
                const std::string text = spoken<D>(binding.command).label;
                if (lines.back().text == text)
                    lines.back().key += ", " + binding.key;
                else
                    lines.push_back({binding.key, text});
            }
        if (lines.back().key.empty()) lines.pop_back();  // a group without keys
    }
    return lines;
}

}  // namespace

template <int D>
void help_sheet(Ui& ui, const Area& area) {
    begin_overlay("help", area);
    ImGui::PushFont(ui.fonts.bold);
    ImGui::TextUnformatted("Keys");
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled(
        "%s", D == 2 ? "Esc closes this. Mouse: click selects, double click runs to a cell, drag pans, wheel zooms."
                     : "Esc closes this. Mouse: click selects, drag orbits, right drag turns, Shift+drag pans, wheel "
                       "zooms. In flight W A S D move, Q and E go down and up.");
    ImGui::PopTextWrapPos();
    const float size = ImGui::GetFontSize(), step = ImGui::GetTextLineHeightWithSpacing(), key_width = 9.5f * size;
    const auto columns = std::max(1, static_cast<int>(area.w / (20 * size)));
    const float w = (area.w - 2 * ImGui::GetStyle().WindowPadding.x) / static_cast<float>(columns);
    const auto lines = help_lines<D>();
    const float room = w - key_width - size;
    const auto height = [&](const HelpLine& line) {
        if (line.key.empty()) return 1.3f * step;
        const float texts = ImGui::CalcTextSize(line.text.c_str(), nullptr, false, room).y;
        return std::max(texts, ImGui::CalcTextSize(line.key.c_str(), nullptr, false, key_width - size).y) + step - size;
    };
    float all = 0;
    for (const HelpLine& line : lines) all += height(line);
    // A little more than an even share, since lines do not part.
    const float share = all / static_cast<float>(columns) + 3 * step;
    const ImVec2 top = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float x = 0, y = 0, lowest = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const HelpLine& line = lines[i];
        float needed = height(line);
        if (line.key.empty() && i + 1 < lines.size()) needed += height(lines[i + 1]);  // no heading alone
        if (y > 0 && y + needed > share) {
            x += w;
            y = 0;
        }
        const ImVec2 at{top.x + x, top.y + y};
        if (line.key.empty()) {
            list.AddText(ui.fonts.bold, size, {at.x, at.y + (y > 0 ? 0.3f * step : 0)}, colour(theme::ink),
                         line.text.c_str());
        } else {
            list.AddText(nullptr, 0, at, colour(theme::accent), line.key.c_str(), nullptr, key_width - size);
            list.AddText(nullptr, 0, {at.x + key_width, at.y}, colour(theme::ink), line.text.c_str(), nullptr, room);
        }
        y += height(line);
        lowest = std::max(lowest, y);
    }
    ImGui::Dummy({w * static_cast<float>(columns), lowest});
    ImGui::End();
}

template void help_sheet<2>(Ui&, const Area&);
template void help_sheet<3>(Ui&, const Area&);

}  // namespace sightline
