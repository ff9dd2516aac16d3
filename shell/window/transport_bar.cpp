// State, buttons, speed and position of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <initializer_list>

#include "core/number.h"
#include "shell/bench/transport.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Shapes on buttons, drawn in a square of side 1.
enum class Icon { start, back10, back, play, pause, step, step10, end, into };

void triangle(ImDrawList& list, const ImVec2& at, float s, float x0, float x1, ImU32 c) {
    list.AddTriangleFilled({at.x + x0 * s, at.y + 0.15f * s}, {at.x + x0 * s, at.y + 0.85f * s},
                           {at.x + x1 * s, at.y + 0.5f * s}, c);
}

void bar(ImDrawList& list, const ImVec2& at, float s, float x0, float x1, ImU32 c) {
    list.AddRectFilled({at.x + x0 * s, at.y + 0.15f * s}, {at.x + x1 * s, at.y + 0.85f * s}, c);
}

void draw_icon(ImDrawList& list, Icon icon, const ImVec2& at, float s, ImU32 c) {
    switch (icon) {
        case Icon::start:
            bar(list, at, s, 0.1f, 0.24f, c);
            return triangle(list, at, s, 0.9f, 0.28f, c);
        case Icon::back10:
            triangle(list, at, s, 0.5f, 0.02f, c);
            return triangle(list, at, s, 0.98f, 0.5f, c);
        case Icon::back:
            bar(list, at, s, 0.78f, 0.9f, c);
            return triangle(list, at, s, 0.7f, 0.1f, c);
        case Icon::play:
            return triangle(list, at, s, 0.2f, 0.9f, c);
        case Icon::pause:
            bar(list, at, s, 0.2f, 0.42f, c);
            return bar(list, at, s, 0.58f, 0.8f, c);
        case Icon::step:
            bar(list, at, s, 0.1f, 0.22f, c);
            return triangle(list, at, s, 0.3f, 0.9f, c);
        case Icon::step10:
            triangle(list, at, s, 0.02f, 0.5f, c);
            return triangle(list, at, s, 0.5f, 0.98f, c);
        case Icon::end:
            triangle(list, at, s, 0.1f, 0.72f, c);
            return bar(list, at, s, 0.76f, 0.9f, c);
        case Icon::into:
            list.AddLine({at.x + 0.5f * s, at.y + 0.08f * s}, {at.x + 0.5f * s, at.y + 0.5f * s}, c, 0.12f * s);
            list.AddTriangleFilled({at.x + 0.22f * s, at.y + 0.42f * s}, {at.x + 0.78f * s, at.y + 0.42f * s},
                                   {at.x + 0.5f * s, at.y + 0.74f * s}, c);
            return list.AddCircleFilled({at.x + 0.5f * s, at.y + 0.88f * s}, 0.1f * s, c);
    }
}

bool icon_button(const char* id, Icon icon, bool enabled, const char* tip) {
    const float side = ImGui::GetFrameHeight(), pad = side * 0.24f;
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(id, {side * 1.25f, side});
    ImGui::EndDisabled();
    const ImVec2 min = ImGui::GetItemRectMin();
    draw_icon(*ImGui::GetWindowDrawList(), icon, {min.x + pad + side * 0.125f, min.y + pad}, side - 2 * pad,
              colour(enabled ? theme::ink : theme::line));
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", tip);
    return pressed;
}

Colour state_colour(TransportState state) {
    switch (state) {
        case TransportState::ready:
            return theme::accent;
        case TransportState::playing:
            return theme::playing;
        case TransportState::paused:
            return theme::paused;
        case TransportState::finished:
            break;
    }
    return theme::ink;
}

void badge(const Ui& ui, std::string_view word, const Colour& fill) {
    const std::string text(word);
    const float h = ImGui::GetFrameHeight(), w = 6.4f * ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({w, h});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + w, at.y + h}, colour(fill), 3 * ui.unit);
    ImGui::PushFont(ui.fonts.bold);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddText({at.x + (w - size.x) / 2, at.y + (h - size.y) / 2}, IM_COL32_WHITE, text.c_str());
    ImGui::PopFont();
}

}  // namespace

template <int D>
void transport_bar(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_part("transport", area);
    const TransportState state = transport_state(bench);
    const std::uint32_t at = bench.session.position(), whole = bench.session.recorded();
    badge(ui, transport_words[static_cast<std::size_t>(state)], state_colour(state));
    note_place(bench, "state " + std::string(transport_words[static_cast<std::size_t>(state)]));
    struct Button {
        const char *id, *command, *tip;
        Icon icon;
        bool enabled;
    };
    const bool playing = state == TransportState::playing;
    const std::array buttons{
        Button{"##start", "seek start", "to the start (Home)", Icon::start, at > 0},
        Button{"##back10", "back 10", "10 steps back (Shift+Left)", Icon::back10, at > 0},
        Button{"##back", "back", "one step back (Left, PageUp)", Icon::back, at > 0},
        Button{"##toggle", "toggle", playing ? "pause (Space)" : "play (Space)", playing ? Icon::pause : Icon::play,
               true},
        Button{"##step", "step", "one step forward (Right, PageDown)", Icon::step, at < whole},
        Button{"##step10", "step 10", "10 steps forward (Shift+Right)", Icon::step10, at < whole},
        Button{"##end", "run", "to the end (End)", Icon::end, at < whole},
    };
    for (const Button& button : buttons) {
        ImGui::SameLine();
        if (icon_button(button.id, button.icon, button.enabled, button.tip)) ui.act(button.command);
        note_place(bench, "button " + std::string(button.command));
    }
    ImGui::SameLine(0, 18 * ui.unit);
    if (ImGui::Button("-")) ui.act("speed half");
    note_place(bench, "button speed half");
    ImGui::SameLine(0, 3 * ui.unit);
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s/s", short_number(bench.transport.steps_per_second).c_str());
    ImGui::SameLine(0, 3 * ui.unit);
    if (ImGui::Button("+")) ui.act("speed double");
    note_place(bench, "button speed double");
    ImGui::SameLine();
    if (ImGui::Button("20 s")) ui.act("play 20s");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("the whole run in 20 seconds (Y)");
    note_place(bench, "button play 20s");
    ImGui::SameLine(0, 18 * ui.unit);
    ImGui::PushFont(ui.fonts.bold);
    ImGui::Text("step %u of %u", at, whole);
    ImGui::PopFont();
    ImGui::SameLine(0, 18 * ui.unit);
    const Session<D>& s = bench.session;
    // A frame of a flight does not wait for its reference.
    const bool measured = !s.flying() || s.has_reference();
    const auto share = measured ? coverage(s.reference(), s.visible_rendered()) : std::nullopt;
    const std::string done =
        std::to_string(s.state().rendered_count) + " rendered, coverage " + (share ? short_number(*share) : "-");
    // Whole or not at all: the panel of the run says it too, and the menus have what the buttons do.
    const auto fits = [&](float width) { return ImGui::GetCursorPosX() + width <= area.w; };
    if (fits(ImGui::CalcTextSize(done.c_str()).x)) {
        ImGui::TextUnformatted(done.c_str());
        ImGui::SameLine();
    }

    const std::array panels{std::pair{"scenes", "Scenes"}, std::pair{"show settings", "Settings"},
                            std::pair{"show why", "Why"}, std::pair{"projector", "Projector"},
                            std::pair{"help", "Keys"}};
    float w = 0;
    for (const auto& [command, title] : panels)
        w += ImGui::CalcTextSize(title).x + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), area.w - w - ImGui::GetStyle().WindowPadding.x));
    for (const auto& [command, title] : panels) {
        if (!fits(ImGui::CalcTextSize(title).x + 2 * ImGui::GetStyle().FramePadding.x)) break;
        if (ImGui::Button(title)) ui.act(command);
        note_place(bench, "button " + std::string(command));
        ImGui::SameLine();
    }
    ImGui::End();
}

template void transport_bar<2>(Ui&, Workbench<2>&, const Area&);
template void transport_bar<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
