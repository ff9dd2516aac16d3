// The line at the lower edge: the last message, or what the mouse and the keys do now.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <span>

#include "shell/commands/menus.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"
#include "shell/window/wrap.h"

namespace sightline {

namespace {

/// The keys that a newcomer needs first.
template <int D>
std::span<const char* const> key_hints() {
    static constexpr std::array in_plane{"Right: next step", "Left: back", "Space: play", "F1: all keys",
                                         "Type : for a command"};
    static constexpr std::array in_space{"Right: next step", "Left: back",     "F1: all keys", "G: fly",
                                         "F: freeze here",   "Z: exact image", "Space: play",  "Type : for a command"};
    if constexpr (D == 2)
        return in_plane;
    else
        return in_space;
}

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
    if (bench.session.settings().automatic == Switch::on) return {"", "auto: " + bench.session.settings().method};
    return {};
}

}  // namespace

template <int D>
void status_line(Ui& ui, Workbench<D>& bench, const Area& area) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * ui.unit, 3 * ui.unit});
    begin_part("status", area);
    ImGui::PopStyleVar();
    const Mode mode = mode_of(bench);
    const float brief = mode.brief.empty() ? 0 : ImGui::CalcTextSize(mode.brief.c_str()).x + 16 * ui.unit;
    const auto show_brief = [&] {
        if (mode.brief.empty()) return;
        ImGui::SameLine(area.w - brief + 6 * ui.unit);
        ImGui::TextUnformatted(mode.brief.c_str());
        note_place(bench, "mode " + mode.brief);
    };
    if (ui.messages.size() > ui.said_before) {
        const Message& message = ui.messages.back();
        const std::string shown = shortened(message.text, area.w - brief - 20 * ui.unit, width_of_line);
        ImGui::PushStyleColor(ImGuiCol_Text, colour(message.bad ? theme::bad : theme::ink));
        ImGui::TextUnformatted(shown.c_str());
        ImGui::PopStyleColor();
        if (shown != message.text && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", message.text.c_str());
        show_brief();
    } else if (!mode.sentence.empty()) {
        const float room = area.w - 20 * ui.unit;
        const bool fits = width_of_line(mode.sentence) < room;
        ImGui::TextUnformatted(shortened(fits ? mode.sentence : mode.brief, room, width_of_line).c_str());
        note_place(bench, "mode " + mode.sentence);
    } else {
        std::string hints;  // as many as there is room for
        for (const char* const hint : key_hints<D>())
            if (width_of_line(hints + hint) < area.w - brief - 20 * ui.unit)
                hints += (hints.empty() ? "" : "   ") + std::string(hint);
        ImGui::TextDisabled("%s", hints.c_str());
        show_brief();
    }
    ImGui::End();
}

template void status_line<2>(Ui&, Workbench<2>&, const Area&);
template void status_line<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
