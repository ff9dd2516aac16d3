// Lines of text across the window, for a class to read.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "shell/window/formula.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

constexpr float smallest_text = 0.4f, shrink = 0.92f;

/// In the current font, times a scale.
FormulaLook formula_look(const Row& line, float room, float scale) {
    ImFont* const font = ImGui::GetFont();
    return {font, font->FontSize * ImGui::GetIO().FontGlobalScale * scale, room, line.captions};
}

/// Of all lines in the current font, times a scale, with what stands around them.
float height_of(const std::vector<Row>& lines, float room, float scale) {
    float height = 2 * ImGui::GetStyle().WindowPadding.y;
    for (const Row& line : lines)
        height += ImGui::GetStyle().ItemSpacing.y +
                  (line.parts.empty() ? scale * ImGui::CalcTextSize(line.text.c_str(), nullptr, false, room / scale).y
                                      : formula_height(line.parts, formula_look(line, room, scale)));
    return height;
}

Colour colour_of(Tone tone) {
    if (tone == Tone::faint) return theme::faint;
    return tone == Tone::lit ? theme::accent : theme::ink;
}

}  // namespace

float block_height(ImFont* font, const std::vector<Row>& lines, float width, float most) {
    ImGui::PushFont(font);
    const float room = std::max(1.0f, width - 2 * ImGui::GetStyle().WindowPadding.x);
    const float height = height_of(lines, room, 1);
    ImGui::PopFont();
    return std::min(height, most);
}

template <int D>
void text_block(Workbench<D>& bench, const char* name, ImFont* font, const std::vector<Row>& lines, const Area& area) {
    begin_part(name, area);
    ImGui::PushFont(font);
    ImGui::SetWindowFontScale(1);  // the window keeps that of the frame before
    const float room = std::max(1.0f, ImGui::GetContentRegionAvail().x);
    float scale = 1;
    while (scale > smallest_text && height_of(lines, room, scale) > area.h + 1) scale *= shrink;
    ImGui::SetWindowFontScale(scale);
    for (const Row& line : lines) {
        if (line.parts.empty()) {
            ImGui::PushStyleColor(ImGuiCol_Text, colour(colour_of(line.tone)));
            ImGui::TextWrapped("%s", line.text.c_str());
            ImGui::PopStyleColor();
        } else {
            const FormulaLook look = formula_look(line, room, scale);
            draw_formula(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), line.parts, look,
                         colour_of(line.tone), {-1, -1});
            ImGui::Dummy({room, formula_height(line.parts, look)});
        }
        note_place(bench, std::string(name) + ": " + line.text);
    }
    ImGui::PopFont();
    ImGui::End();
}

template void text_block<2>(Workbench<2>&, const char*, ImFont*, const std::vector<Row>&, const Area&);
template void text_block<3>(Workbench<3>&, const char*, ImFont*, const std::vector<Row>&, const Area&);

}  // namespace sightline
