// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/note_field.h"

#include <imgui_stdlib.h>

#include <algorithm>

#include "shell/commands/command_table.h"
#include "shell/window/theme.h"

namespace sightline {

void NoteField::open(const ImVec2& at, std::string command, std::string after, std::string text, std::uint32_t from,
                     std::uint32_t to) {
    open_ = focus_ = true;
    at_ = at;
    command_ = std::move(command);
    after_ = std::move(after);
    text_ = std::move(text);
    from_ = from > 0 ? std::to_string(from) : "";
    to_ = to != none ? std::to_string(to) : "";
}

void NoteField::open_new(const ImVec2& at, Tool tool, const std::string& anchor, const char* offset) {
    open(at, "note " + std::string(tool_words[static_cast<std::size_t>(tool)]) + " " + anchor + " " + offset,
         "tool select");
}

bool NoteField::close() {
    const bool was = open_;
    open_ = false;
    return was;
}

void NoteField::draw(Ui& ui, const Area& area) {
    if (!open_) return;
    const float font = ImGui::GetFontSize(), w = std::min(21 * font, area.w), h = 5.2f * font;
    ImGui::SetNextWindowPos({std::clamp(at_.x + 10 * ui.unit, area.x, std::max(area.x, area.x + area.w - w)),
                             std::clamp(at_.y + 10 * ui.unit, area.y, std::max(area.y, area.y + area.h - h))});
    ImGui::SetNextWindowSize({w, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colour(theme::paper));
    ImGui::PushStyleColor(ImGuiCol_Border, colour(theme::accent));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0f, 1.5f * ui.unit));
    if (focus_) ImGui::SetNextWindowFocus();
    ImGui::Begin("note", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNavFocus);  // but Tab goes from field to field
    if (focus_) ImGui::SetKeyboardFocusHere();
    focus_ = false;
    ImGui::SetNextItemWidth(-1);
    bool done = ImGui::InputTextWithHint("##text", "text of the note", &text_, ImGuiInputTextFlags_EnterReturnsTrue);
    const auto step = [&](const char* label, const char* hint, std::string& value) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(label);
        ImGui::SameLine();
        ImGui::SetNextItemWidth(4.5f * font);
        done |= ImGui::InputTextWithHint((std::string("##") + hint).c_str(), hint, &value,
                                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CharsDecimal);
    };
    step("from step", "start", from_);
    ImGui::SameLine();
    step("to step", "end", to_);
    ImGui::TextDisabled("Enter saves, Esc cancels");
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    if (!done) return;
    open_ = false;
    if (text_.empty()) return;
    ui.act(quote_command(command_ + " {" + (from_.empty() ? "0" : from_) + "-" + to_ + "} " + text_) +
           (after_.empty() ? "" : "; " + after_));
}

}  // namespace sightline
