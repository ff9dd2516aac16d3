// The lines at the edges: the last message, and the formula of the projector mode.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

template <int D>
void status_line(Ui& ui, Workbench<D>& bench, const Area& area) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * ui.unit, 3 * ui.unit});
    begin_part("status", area);
    ImGui::PopStyleVar();
    if (ui.messages.empty()) {
        ImGui::TextDisabled("Right: next step   Left: back   Space: play   F1: all keys   : types a command");
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

float banner_height(const Ui& ui) { return ui.fonts.banner->FontSize / ui.framebuffer * 1.25f * 2 + 14 * ui.unit; }

template <int D>
void projector_banner(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_part("banner", area);
    ImGui::PushFont(ui.fonts.banner);
    const Session<D>& s = bench.session;
    if (s.position() == 0) {
        ImGui::TextWrapped("Step 0 of %u: the seed cell is in the front, nothing is projected yet.", s.recorded());
    } else {
        const StepExplanation step = explain_step(s, s.position());
        ImGui::TextWrapped("%s", sentence(step).c_str());
    }
    ImGui::PopFont();
    ImGui::End();
}

template void status_line<2>(Ui&, Workbench<2>&, const Area&);
template void projector_banner<2>(Ui&, Workbench<2>&, const Area&);

}  // namespace sightline
