// The line over the picture: what is shown, and where to go from here.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/session/headline.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"
#include "shell/window/wrap.h"

namespace sightline {

namespace {

/// Those that do not fit are left out, the last first: the menus have what they do.
template <int D>
std::vector<std::pair<const char*, const char*>> buttons_that_fit(float room, float& width) {
    std::vector<std::pair<const char*, const char*>> buttons{{"lesson", "Lessons"},       {"scenes", "Scenes"},
                                                             {"show compare", "Compare"}, {"show settings", "Settings"},
                                                             {"projector", "Projector"},  {"help", "Keys"}};
    buttons.insert(buttons.begin() + 2, {"path", "Path"});
    if (D == 3) buttons.insert(buttons.begin() + 2, {"fly", "Fly"});
    const ImGuiStyle& style = ImGui::GetStyle();
    width = 0;
    std::size_t fits = 0;
    for (; fits < buttons.size(); ++fits) {
        const float w = ImGui::CalcTextSize(buttons[fits].second).x + 2 * style.FramePadding.x + style.ItemSpacing.x;
        if (width + w > room) break;
        width += w;
    }
    buttons.resize(fits);
    return buttons;
}

}  // namespace

template <int D>
void title_line(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_part("title", area);
    const float pad = ImGui::GetStyle().WindowPadding.x;
    float width = 0;
    const auto buttons = buttons_that_fit<D>(area.w * 0.6f, width);
    const std::string text = headline(bench.session);
    ImGui::AlignTextToFramePadding();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = area.w - width - 3 * pad;
    ImGui::PushFont(ui.fonts.bold);
    const float line = ImGui::GetFontSize(), wide = ImGui::CalcTextSize(text.c_str()).x;
    // Whole: where it is too long it is written smaller, and where that is not enough its tooltip has the rest.
    const float scale = std::clamp(room / wide, 0.75f, 1.0f);
    const std::string shown = shortened(text, room / scale, width_of_line);
    ImGui::GetWindowDrawList()->AddText(ui.fonts.bold, line * scale, {at.x, at.y + ImGui::GetStyle().FramePadding.y},
                                        colour(theme::ink), shown.c_str());
    ImGui::PopFont();
    ImGui::Dummy({std::max(std::min(wide, room), 1.0f), line});
    note_place(bench, "title " + text);
    if (shown != text && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
    ImGui::SetCursorScreenPos({area.x + std::max(area.w - width, pad), at.y});
    for (const auto& [command, title] : buttons) {
        if (ImGui::Button(title)) ui.act(command);
        note_place(bench, "button " + std::string(command));
        ImGui::SameLine();
    }
    ImGui::End();
}

template void title_line<2>(Ui&, Workbench<2>&, const Area&);
template void title_line<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
