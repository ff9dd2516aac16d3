// The line at the lower edge: the last message, or what the keys do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

template <int D>
void status_line(Ui& ui, Workbench<D>& bench, const Area& area) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * ui.unit, 3 * ui.unit});
    begin_part("status", area);
    ImGui::PopStyleVar();
    if (ui.messages.size() <= ui.said_before) {
        ImGui::TextDisabled("%sRight: next step   Left: back   Space: play   F1: all keys   Type : for a command",
                            D == 3 ? "G: fly   F: freeze here   Z: exact image   " : "");
    } else {
        const Message& message = ui.messages.back();
        ImGui::PushStyleColor(ImGuiCol_Text, colour(message.bad ? theme::bad : theme::ink));
        ImGui::TextUnformatted(message.text.c_str());
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", message.text.c_str());
    }
    if (bench.desk.tool != Tool::select) {
        const std::string text =
            "tool: " + std::string(tool_words[static_cast<std::size_t>(bench.desk.tool)]) + " (V: select)";
        ImGui::SameLine(area.w - ImGui::CalcTextSize(text.c_str()).x - 12 * ui.unit);
        ImGui::TextUnformatted(text.c_str());
    }
    ImGui::End();
}

template void status_line<2>(Ui&, Workbench<2>&, const Area&);
template void status_line<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
