// The lessons and their parts, over the picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/parts.h"

namespace sightline {

template <int D>
void lesson_sheet(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_overlay("lessons", area);
    ImGui::PushFont(ui.fonts.bold);
    ImGui::TextUnformatted("Lessons");
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled("PageDown and PageUp go through a lesson, P is for the projector, Esc closes this");
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
            if (ImGui::Selectable(label.c_str())) chosen = lesson.id + " " + std::to_string(i + 1);
            note_place(bench, "lesson " + lesson.id + " " + std::to_string(i + 1));
        }
    }
    ImGui::EndChild();
    ImGui::End();
    if (!chosen.empty()) ui.act("lesson " + chosen);
}

template void lesson_sheet<2>(Ui&, Workbench<2>&, const Area&);
template void lesson_sheet<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
