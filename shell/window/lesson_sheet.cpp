// The lessons and their parts, over the picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "shell/window/parts.h"

namespace sightline {

namespace {

bool went(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

/// The row that the arrow keys lead to, over all lessons; at first that of the part which is given.
template <int D>
int lit_lesson_row(const Workbench<D>& bench, bool& moved) {
    int& at = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("lit"), 0);
    int rows = 0, given = 0;
    for (const Lesson& lesson : bench.lessons) {
        if (lesson.dimension != D) continue;
        if (bench.teaching && bench.teaching->lesson.id == lesson.id)
            given = rows + static_cast<int>(bench.teaching->part);
        rows += static_cast<int>(lesson.parts.size());
    }
    const int before = at;
    if (ImGui::IsWindowAppearing()) at = given;
    at = std::clamp(at + went(ImGuiKey_DownArrow) - went(ImGuiKey_UpArrow), 0, std::max(rows - 1, 0));
    moved = at != before || ImGui::IsWindowAppearing();
    return at;
}

}  // namespace

template <int D>
void lesson_sheet(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_overlay("lessons", area);
    ImGui::PushFont(ui.fonts.bold);
    ImGui::TextUnformatted("Lessons");
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled(
        "Arrows and Enter choose, PageDown and PageUp go through a lesson, P is for the projector, Esc closes this");
    bool moved = false;
    const int lit = lit_lesson_row(bench, moved);
    const bool entered = went(ImGuiKey_Enter) || went(ImGuiKey_KeyPadEnter);
    int row = 0;
    ImGui::BeginChild("list");
    std::string chosen;
    for (const Lesson& lesson : bench.lessons) {
        if (lesson.dimension != D) continue;
        ImGui::Dummy({1, 4 * ui.unit});
        ImGui::PushFont(ui.fonts.bold);
        ImGui::Text("%s, %d minutes", lesson.title.c_str(), lesson.minutes());
        ImGui::PopFont();
        for (std::size_t i = 0; i < lesson.parts.size(); ++i) {
            const LessonPart& part = lesson.parts[i];
            const std::string label = std::to_string(i + 1) + "  " + part.title + "##" + lesson.id;
            const std::string part_words = lesson.id + " " + std::to_string(i + 1);
            const bool here = row++ == lit;
            if (ImGui::Selectable(label.c_str(), here) || (here && entered)) chosen = part_words;
            note_place(bench, "lesson " + part_words);
            if (!here) continue;
            note_place(bench, "lit lesson " + part_words);
            if (moved) ImGui::SetScrollHereY();
        }
    }
    ImGui::EndChild();
    ImGui::End();
    if (!chosen.empty()) ui.act("lesson " + chosen);
}

template void lesson_sheet<2>(Ui&, Workbench<2>&, const Area&);
template void lesson_sheet<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
