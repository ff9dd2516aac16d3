// The flight path: which, where in it, replay, record and save.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>

#include "shell/commands/prompt.h"
#include "shell/desk/fly.h"
#include "shell/desk/undo.h"
#include "shell/window/buttons.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

template <int D>
void path_choice(Ui& ui, Workbench<D>& bench) {
    const Flight<D>& flight = bench.flight;
    const std::string shown = flight.path.frames.empty() ? "no path" : flight.path.id;
    ImGui::SetNextItemWidth(8 * ImGui::GetFontSize());
    const bool open = ImGui::BeginCombo("##path", shown.c_str());
    note_place(bench, "path " + shown);
    if (ImGui::IsItemHovered() && !open) ImGui::SetTooltip("choose a path of the scene, or open one from a file");
    if (!open) return;
    std::string chosen;
    for (const FlightPath<D>& path : bench.session.scene().paths)
        if (ImGui::Selectable(path.id.c_str(), path.id == flight.path.id)) chosen = "path " + path.id;
    if (ImGui::Selectable("open a file …")) ask(bench, "path open");
    ImGui::EndCombo();
    if (!chosen.empty()) ui.act(chosen);
}

/// Its frames, unrecorded while the mouse holds it.
template <int D>
void frame_slider(Ui& ui, Workbench<D>& bench, float width) {
    Flight<D>& flight = bench.flight;
    const std::size_t count = flight.path.frames.size();
    ImGui::BeginDisabled(count < 2 || flight.recording);
    ImGui::SetNextItemWidth(width);
    int frame = static_cast<int>(flight.frame);
    if (ImGui::SliderInt("##frame", &frame, 0, std::max(1, static_cast<int>(count) - 1), "",
                         ImGuiSliderFlags_NoInput)) {
        go_to_frame(bench, static_cast<std::uint32_t>(frame));
        ++ui.revision;
    }
    note_place(bench, "path frames");
    if (ImGui::IsItemDeactivated()) {
        end_gesture(bench);
        land_unless_moving(bench);
        ++ui.revision;
    }
    ImGui::EndDisabled();
}

}  // namespace

template <int D>
void path_bar(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_part("path", area);
    const Flight<D>& flight = bench.flight;
    const std::size_t count = flight.path.frames.size();
    const bool any = count > 0 && !flight.recording, playing = flight.replaying;
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.fonts.bold);
    ImGui::TextUnformatted("Path");
    ImGui::PopFont();
    ImGui::SameLine();
    path_choice(ui, bench);
    struct Button {
        const char *id, *command, *tip;
        Icon icon;
        bool enabled;
    };
    const std::array buttons{
        Button{"##start", "path start", "to its first frame (Shift+Home)", Icon::start, any && flight.frame > 0},
        Button{"##back", "path back", "one frame back (Shift+PageUp)", Icon::back, any && flight.frame > 0},
        Button{"##toggle", "path toggle", playing ? "stop (Shift+Space)" : "play the path (Shift+Space)",
               playing ? Icon::pause : Icon::play, any},
        Button{"##step", "path step", "one frame forward (Shift+PageDown)", Icon::step,
               any && flight.frame + 1 < count},
    };
    std::string wanted;  // what changes the path is done when all of it has been drawn
    for (const Button& button : buttons) {
        ImGui::SameLine(0, button.icon == Icon::start ? 12 * ui.unit : -1);
        if (icon_button(button.id, button.icon, button.enabled, button.tip)) wanted = button.command;
        note_place(bench, "button " + std::string(button.command));
    }
    const auto width_of = [](const char* text) {
        return ImGui::CalcTextSize(text).x + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x;
    };
    const std::string where = flight.recording ? std::to_string(count) + " frames"
                              : count == 0     ? "choose a path, or record one"
                                           : "frame " + std::to_string(flight.frame) + " of " + std::to_string(count);
    const char* const record = flight.recording ? "Stop" : "Record";
    const float words = std::max(width_of("frame 8888 of 8888"), width_of(where.c_str()));
    const float tail = words + width_of("Loop") + width_of(record) + ImGui::GetFrameHeight() + width_of("Save …");
    ImGui::SameLine(0, 12 * ui.unit);
    const float room = area.w - ImGui::GetCursorPosX() - tail - 24 * ui.unit;
    if (room > 40 * ui.unit) {
        frame_slider(ui, bench, room);
        ImGui::SameLine();
    }
    const float at = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(where.c_str());
    note_place(bench, where);
    ImGui::SameLine(at + words);
    ImGui::PushStyleColor(ImGuiCol_Button, colour(flight.loop ? theme::hover : theme::paper));
    if (ImGui::Button("Loop")) wanted = "path loop";
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("repeat the path (Shift+L)");
    note_place(bench, flight.loop ? "button path loop, on" : "button path loop");
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, colour(flight.recording ? theme::bad : theme::ink));
    if (ImGui::Button(record)) wanted = "path record";
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(flight.recording ? "stop recording (Shift+R)" : "record a new path as you fly (Shift+R)");
    note_place(bench, flight.recording ? "button path record, on" : "button path record");
    ImGui::SameLine();
    ImGui::BeginDisabled(!any);
    if (ImGui::Button("Save …")) ask(bench, "path save");
    ImGui::EndDisabled();
    note_place(bench, "button path save");
    ImGui::End();
    if (!wanted.empty()) ui.act(wanted);
}

template void path_bar<2>(Ui&, Workbench<2>&, const Area&);
template void path_bar<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
