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

template <int D>
void state_badge(Ui& ui, Workbench<D>& bench) {
    const TransportState state = transport_state(bench);
    const bool flying = bench.session.flying();
    const std::string word = flying ? "flying" : std::string(transport_words[static_cast<std::size_t>(state)]);
    badge(ui, word, flying ? theme::playing : state_colour(state));
    note_place(bench, "state " + word);
}

template <int D>
void step_buttons(Ui& ui, Workbench<D>& bench) {
    struct Button {
        const char *id, *command, *tip;
        Icon icon;
        bool enabled;
    };
    const bool playing = transport_state(bench) == TransportState::playing;
    const bool begun = bench.session.position() > 0, ended = bench.session.position() >= bench.session.recorded();
    const std::array buttons{
        Button{"##start", "seek start", "to the start (Home)", Icon::start, begun},
        Button{"##back10", "back 10", "10 steps back (Shift+Left)", Icon::back10, begun},
        Button{"##back", "back", "one step back (Left, PageUp)", Icon::back, begun},
        Button{"##toggle", "toggle", playing ? "pause (Space)" : "play (Space)", playing ? Icon::pause : Icon::play,
               true},
        Button{"##step", "step", "one step forward (Right, PageDown)", Icon::step, !ended},
        Button{"##step10", "step 10", "10 steps forward (Shift+Right)", Icon::step10, !ended},
        Button{"##end", "run", "to the end (End)", Icon::end, !ended},
    };
    for (const Button& button : buttons) {
        ImGui::SameLine();
        if (icon_button(button.id, button.icon, button.enabled, button.tip)) ui.act(button.command);
        note_place(bench, "button " + std::string(button.command));
    }
}

template <int D>
void speed_buttons(Ui& ui, Workbench<D>& bench) {
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
}

bool fits(const Area& area, float width) { return ImGui::GetCursorPosX() + width <= area.w; }

template <int D>
void position_text(Ui& ui, const Session<D>& s, const Area& area) {
    ImGui::SameLine(0, 18 * ui.unit);
    ImGui::PushFont(ui.fonts.bold);
    if (s.flying())
        ImGui::TextUnformatted("not recorded");
    else
        ImGui::Text("step %u of %u", s.position(), s.recorded());
    ImGui::PopFont();
    ImGui::SameLine(0, 18 * ui.unit);
    if (D == 3) return;  // the rest stands above the picture
    const auto share = coverage(s.reference(), s.visible_rendered());
    const std::string done =
        std::to_string(s.counters().rendered_count) + " rendered, coverage " + (share ? short_number(*share) : "-");
    // Whole or not at all: the panel of the run says it too.
    if (!fits(area, ImGui::CalcTextSize(done.c_str()).x)) return;
    ImGui::TextUnformatted(done.c_str());
    ImGui::SameLine();
}

/// At the right end; those that do not fit are left out: the menus have what they do.
template <int D>
void panel_buttons(Ui& ui, Workbench<D>& bench, const Area& area) {
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
        if (!fits(area, ImGui::CalcTextSize(title).x + 2 * ImGui::GetStyle().FramePadding.x)) break;
        if (ImGui::Button(title)) ui.act(command);
        note_place(bench, "button " + std::string(command));
        ImGui::SameLine();
    }
}

}  // namespace

template <int D>
void transport_bar(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_part("transport", area);
    state_badge(ui, bench);
    step_buttons(ui, bench);
    speed_buttons(ui, bench);
    position_text(ui, bench.session, area);
    panel_buttons(ui, bench, area);
    ImGui::End();
}

template void transport_bar<2>(Ui&, Workbench<2>&, const Area&);
template void transport_bar<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
