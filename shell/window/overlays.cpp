// What comes over the picture. The console is here; the scene chooser and the sheets have files of their own.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "shell/commands/command_table.h"
#include "shell/commands/completion.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Until the keyboard has come to a line, whose text Dear ImGui marks then.
constexpr int frames_to_open = 5;

/// The commands that fit, or what the command takes.
template <int D>
void suggestions(Ui& ui, const Workbench<D>& bench, const std::string& typed) {
    if (ui.completed_for != typed || ImGui::IsWindowAppearing()) {
        ui.completion = completions(bench, typed);
        ui.completed_for = typed;
    }
    const std::string_view word = std::string_view(typed).substr(0, typed.find(' '));
    for (const Command<D>& command : command_table<D>()) {
        if (command.id != word) continue;
        ImGui::TextUnformatted((std::string(command.id) + " " + std::string(command.arguments)).c_str());
        ImGui::TextDisabled("%s", std::string(command.text).c_str());
    }
    std::string words;
    for (const std::string& each : ui.completion.words) words += (words.empty() ? "" : "   ") + each;
    if (!words.empty()) ImGui::TextWrapped("Tab: %s", one_line(words, 400).c_str());
}

/// Up and down go through what was typed before, Tab completes; what is marked when the line opens is not replaced by
/// the first letter.
template <int D>
struct Typing {
    Ui& ui;
    const Workbench<D>& bench;

    void replace(ImGuiInputTextCallbackData& data, const std::string& text) const {
        data.DeleteChars(0, data.BufTextLen);
        data.InsertChars(0, text.c_str());
    }
    void recall(ImGuiInputTextCallbackData& data) const {
        const auto count = static_cast<int>(ui.typed.size());
        if (ui.recalled == 0) ui.draft.assign(data.Buf, static_cast<std::size_t>(data.BufTextLen));
        ui.recalled = std::clamp(ui.recalled + (data.EventKey == ImGuiKey_UpArrow ? 1 : -1), 0, count);
        replace(data, ui.recalled == 0 ? ui.draft : ui.typed[static_cast<std::size_t>(count - ui.recalled)]);
    }
    static int event(ImGuiInputTextCallbackData* data) {
        const Typing& typing = *static_cast<const Typing*>(data->UserData);
        if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory) typing.recall(*data);
        if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
            const std::string line(data->Buf, static_cast<std::size_t>(data->BufTextLen));
            typing.replace(*data, completed(line, completions(typing.bench, line)));
        }
        if (data->EventFlag == ImGuiInputTextFlags_CallbackAlways && typing.ui.line_opens > 0)
            data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
        if (data->EventFlag == ImGuiInputTextFlags_CallbackAlways && std::exchange(typing.ui.line_failed, false)) {
            data->SelectionStart = 0;
            data->SelectionEnd = data->CursorPos = data->BufTextLen;
        }
        return 0;
    }
};

template <int D>
void run_typed(Ui& ui, Workbench<D>& bench) {
    const std::string commands = bench.desk.console_text;
    const std::size_t before = ui.messages.size();
    bench.desk.console_text.clear();
    bench.desk.console = false;
    if (!commands.empty() && (ui.typed.empty() || ui.typed.back() != commands)) ui.typed.push_back(commands);
    ui.recalled = 0;
    ui.act(commands);
    // What one line cannot say stays open to be read, what was wrong to be mended.
    const bool bad = ui.messages.size() > before && ui.messages.back().bad;
    if (bad) bench.desk.console_text = commands;
    ui.line_failed = bad;
    if (bad || ui.messages.size() > before + 1) {
        bench.desk.console = true;
        ImGui::SetKeyboardFocusHere(-1);
    }
}

template <int D>
void console(Ui& ui, Workbench<D>& bench, const Area& area) {
    const float h = std::min(area.h, 15 * ImGui::GetTextLineHeightWithSpacing());
    begin_overlay("console", {area.x, area.y + area.h - h, area.w, h});
    const float line = ImGui::GetFrameHeightWithSpacing();
    ImGui::BeginChild("said", {0, -line - 6 * ImGui::GetTextLineHeightWithSpacing()});
    for (const Message& message : ui.messages) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour(message.bad ? theme::bad : theme::faint));
        ImGui::TextWrapped("%s", message.text.c_str());
        ImGui::PopStyleColor();
    }
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - line) ImGui::SetScrollHereY(1);
    ImGui::EndChild();
    if (ImGui::IsWindowAppearing()) {
        ImGui::SetKeyboardFocusHere();
        ui.recalled = 0;
        ui.line_opens = frames_to_open;
        ui.line_failed = false;
    }
    ui.line_opens = std::max(0, ui.line_opens - 1);
    ImGui::SetNextItemWidth(-1);
    Typing<D> typing{ui, bench};
    if (ImGui::InputTextWithHint("##line",
                                 "a command, e.g. until rho > 0.5 && visible_share == 0; Tab completes, Up recalls",
                                 &bench.desk.console_text,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways |
                                     ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_CallbackCompletion,
                                 Typing<D>::event, &typing))
        run_typed(ui, bench);
    note_place(bench, "console " + bench.desk.console_text);
    suggestions(ui, bench, bench.desk.console_text);
    ImGui::End();
}

}  // namespace

bool close_topmost(Desk& desk) {
    if (const int dropped = ImGui::GetCurrentContext()->OpenPopupStack.Size; dropped > 0) {
        ImGui::ClosePopupToLevel(dropped - 1, true);
        return true;
    }
    if (desk.console) desk.console_text.clear();
    if (!desk.console && desk.chooser) desk.chooser_text.clear();
    for (bool* const open : {&desk.blank, &desk.console, &desk.help, &desk.lessons, &desk.chooser})
        if (std::exchange(*open, false)) return true;
    return false;
}

template <int D>
void overlays(Ui& ui, Workbench<D>& bench, const Stage& stage, const Area& area) {
    if (bench.desk.chooser) scene_chooser(ui, bench, stage, area);
    if (bench.desk.lessons) lesson_sheet(ui, bench, area);
    if (bench.desk.help) help_sheet<D>(ui, area);
    if (bench.desk.console) console(ui, bench, area);
}

template void overlays<2>(Ui&, Workbench<2>&, const Stage&, const Area&);
template void overlays<3>(Ui&, Workbench<3>&, const Stage&, const Area&);

}  // namespace sightline
