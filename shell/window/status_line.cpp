// The line at the lower edge: the last message, or what the mouse and the keys do now.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands/menus.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// What the mouse does that it does not always do: a sentence, and a few words where a message has its place.
struct Mode {
    std::string sentence, brief;
};

template <int D>
Mode mode_of(const Workbench<D>& bench) {
    const Tool tool = bench.desk.tool;
    if (tool == Tool::gap)
        return {"Cut a gap: click two points of one wall, or drag along it. V ends this.", "cut a gap (V ends it)"};
    if (tool == Tool::segment)
        return {"Draw a wall: drag from one end to the other. V ends this.", "draw walls (V ends it)"};
    if (tool != Tool::select) {
        const std::string what = spoken<D>("tool " + std::string(tool_words[static_cast<std::size_t>(tool)])).label;
        return {what + ": click the place in the picture. V ends this.", what + " (V ends it)"};
    }
    if (bench.desk.edit)
        return {"Edit mode: drag a wall, its ends, or the handles of the view. Shift+G cuts a gap. W ends this.",
                "edit mode (W ends it)"};
    if (bench.session.frozen())
        return {"Frozen: what is drawn stays as it was, only your own view moves. Shift+F ends this.",
                "frozen (Shift+F ends it)"};
    return {};
}

}  // namespace

template <int D>
void status_line(Ui& ui, Workbench<D>& bench, const Area& area) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * ui.unit, 3 * ui.unit});
    begin_part("status", area);
    ImGui::PopStyleVar();
    const Mode mode = mode_of(bench);
    if (ui.messages.size() > ui.said_before) {
        const Message& message = ui.messages.back();
        ImGui::PushStyleColor(ImGuiCol_Text, colour(message.bad ? theme::bad : theme::ink));
        ImGui::TextUnformatted(message.text.c_str());
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", message.text.c_str());
        if (!mode.brief.empty()) {
            const float w = ImGui::CalcTextSize(mode.brief.c_str()).x + 16 * ui.unit;
            const ImVec2 at{area.x + area.w - w, area.y};
            ImGui::GetWindowDrawList()->AddRectFilled(at, area.max(), colour(theme::panel));
            ImGui::SameLine(area.w - w + 6 * ui.unit);
            ImGui::TextUnformatted(mode.brief.c_str());
        }
    } else if (!mode.sentence.empty()) {
        const bool fits = ImGui::CalcTextSize(mode.sentence.c_str()).x < area.w - 20 * ui.unit;
        ImGui::TextUnformatted((fits ? mode.sentence : mode.brief).c_str());
        note_place(bench, "mode " + mode.sentence);
    } else {
        ImGui::TextDisabled("%sRight: next step   Left: back   Space: play   F1: all keys   Type : for a command",
                            D == 3 ? "G: fly   F: freeze here   Z: exact image   " : "");
    }
    ImGui::End();
}

template void status_line<2>(Ui&, Workbench<2>&, const Area&);
template void status_line<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
