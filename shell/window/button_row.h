// Buttons in a row that wraps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <string>

#include "shell/window/theme.h"

namespace sightline {

class ButtonRow {
public:
    explicit ButtonRow(float gap) : gap_(gap) {}
    /// Whether it was pressed. `open`: what it opens is open.
    bool add(const std::string& title, bool open) {
        const float w = ImGui::CalcTextSize(title.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
        if (!first_ && ImGui::GetItemRectMax().x + gap_ + w < right_) ImGui::SameLine(0, gap_);
        first_ = false;
        if (open) ImGui::PushStyleColor(ImGuiCol_Button, colour(theme::hover));
        const bool pressed = ImGui::Button(title.c_str());
        if (open) ImGui::PopStyleColor();
        return pressed;
    }

private:
    float gap_;
    float right_ = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    bool first_ = true;
};

}  // namespace sightline
