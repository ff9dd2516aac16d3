// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/buttons.h"

#include "shell/window/theme.h"

namespace sightline {

namespace {

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
        case Icon::end:
            triangle(list, at, s, 0.1f, 0.72f, c);
            return bar(list, at, s, 0.76f, 0.9f, c);
    }
}

}  // namespace

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

}  // namespace sightline
