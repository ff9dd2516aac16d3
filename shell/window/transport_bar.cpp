// State, buttons, speed and position of the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number.h"
#include "shell/desk/play.h"
#include "shell/window/buttons.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

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

}  // namespace

template <int D>
void transport_bar(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_part("transport", area);
    const TransportState state = transport_state(bench);
    const std::uint32_t at = bench.session.position(), whole = bench.session.recorded();
    const Session<D>& s = bench.session;
    const std::string word = s.flying() ? "flying" : std::string(transport_words[static_cast<std::size_t>(state)]);
    badge(ui, word, s.flying() ? theme::playing : state_colour(state));
    note_place(bench, "state " + word);
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
    if (s.flying())
        ImGui::TextUnformatted("not recorded");
    else
        ImGui::Text("step %u of %u", at, whole);
    ImGui::PopFont();
    ImGui::SameLine(0, 18 * ui.unit);
    // Whole or not at all: the panel of the run says it too, and the menus have what the buttons do.
    const auto fits = [&](float width) { return ImGui::GetCursorPosX() + width <= area.w; };
    if (D == 2) {  // above the picture in 3D
        const auto share = coverage(s.reference(), s.visible_rendered());
        const std::string done =
            std::to_string(s.state().rendered_count) + " rendered, coverage " + (share ? short_number(*share) : "-");
        if (fits(ImGui::CalcTextSize(done.c_str()).x)) {
            ImGui::TextUnformatted(done.c_str());
            ImGui::SameLine();
        }
    }

    std::vector<std::pair<const char*, const char*>> panels{{"scenes", "Scenes"},
                                                            {"show settings", "Settings"},
                                                            {"show why", "Why"},
                                                            {"projector", "Projector"},
                                                            {"help", "Keys"}};
    if (D == 3) panels.insert(panels.begin() + 1, {{"fly", "Fly"}, {"path", "Path"}});
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
