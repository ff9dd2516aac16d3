// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/splitter.h"

#include <algorithm>
#include <cmath>

#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

double splitter(const Ui& ui, const char* name, const Area& strip, const SplitterRange& split, double size) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    begin_part(name, strip);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton("strip", {std::max(1.0f, strip.w), std::max(1.0f, strip.h)});
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(split.upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled(strip.min(), strip.max(), colour(held ? theme::accent : theme::line));
    }
    if (held) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const float asked = std::abs((split.upright ? mouse.x : mouse.y) - split.fixed) - splitter_width(ui) / 2;
        size = std::clamp(asked, split.least, std::max(split.least, split.most)) / ui.unit;
    }
    ImGui::End();
    return size;
}

}  // namespace sightline
