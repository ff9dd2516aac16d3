// Rows of a panel: wrapped text, a click runs the row's command, the mouse over a row outlines its cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/glossary.h"
#include "shell/window/formula.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"
#include "shell/window/wrap.h"

namespace sightline {

namespace {

Colour tone_colour(Tone tone) {
    if (tone == Tone::faint) return theme::faint;
    if (tone == Tone::good) return theme::good;
    if (tone == Tone::bad) return theme::bad;
    if (tone == Tone::link) return theme::accent;
    return theme::ink;
}

void tooltip(const std::string& text) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(30 * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// Underlines the term of the glossary that is under the mouse, and says what it means. The text is in the current
/// font, with its line breaks.
bool explain_term(ImDrawList& list, const ImVec2& start, std::string_view text) {
    const ImVec2 mouse = ImGui::GetMousePos();
    const float size = ImGui::GetFontSize();
    float y = start.y;
    for (; mouse.y >= y + size; y += size) {
        const std::size_t end = text.find('\n');
        if (end == text.npos) return false;
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    const auto width = [&](std::size_t count) { return width_of_line(text.substr(0, count)); };
    std::size_t at = 0;
    while (at < text.size() && start.x + width(at + 1) <= mouse.x) ++at;
    if (at == text.size() || mouse.x < start.x) return false;
    const TermSpot spot = term_at(text, at);
    if (!spot.entry) return false;
    list.AddLine({start.x + width(spot.first), y + size}, {start.x + width(spot.first + spot.count), y + size},
                 colour(theme::accent));
    tooltip(std::string(spot.entry->term) + ": " + std::string(spot.entry->sentence));
    return true;
}

}  // namespace

void draw_rows(Ui& ui, const std::vector<Row>& rows, std::uint32_t hovered_cell) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float room = ImGui::GetContentRegionAvail().x, top = ImGui::GetWindowPos().y,
                bottom = top + ImGui::GetWindowHeight();
    std::string command;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        const float indent = static_cast<float>(row.indent) * 1.1f * ImGui::GetFontSize();
        ImFont* const font = row.tone == Tone::heading ? ui.fonts.bold : ui.fonts.text;
        ImGui::PushFont(font);
        if (row.tone == Tone::heading && i > 0) ImGui::Dummy({1, 4 * ui.unit});
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float wrap = std::max(room - indent, 40.0f);
        const bool fits = width_of_line(row.text) <= wrap;
        const std::string text = fits ? row.text : wrapped_at_spaces(row.text, wrap, width_of_line);
        const FormulaLook formula{font, ImGui::GetFontSize(), wrap, row.captions};
        ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
        if (!row.parts.empty()) size.y = formula_height(row.parts, formula);
        ImGui::PushID(static_cast<int>(i));
        ImGui::InvisibleButton("row", {room, std::max(size.y, 1.0f)});
        ImGui::PopID();
        if (row.tone == Tone::lit && ui.followed != ui.revision) {
            ui.followed = ui.revision;
            if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY();
        }
        if (ImGui::IsItemClicked() && !row.command.empty()) command = row.command;
        const bool hovered = ImGui::IsItemHovered();
        if (at.y + size.y >= top && at.y <= bottom) {
            const ImVec2 end{at.x + room, at.y + size.y};
            const bool active = row.cell != none && row.cell == hovered_cell;
            if (row.tone == Tone::lit) list.AddRectFilled(at, end, colour(theme::lit));
            if (active || (hovered && !row.command.empty())) list.AddRectFilled(at, end, colour(theme::hover));
            const ImVec2 start{at.x + indent, at.y};
            const ImVec2 mouse = hovered ? ImGui::GetMousePos() : ImVec2(-1, -1);
            if (row.parts.empty())
                list.AddText(font, formula.size, start, colour(tone_colour(row.tone)), text.c_str(), nullptr, wrap);
            else if (const KeyAbout about = draw_formula(list, start, row.parts, formula, tone_colour(row.tone), mouse);
                     about != KeyAbout::nothing) {
                ui.lighting = row.light;
                ui.lighting.about = about;
            }
        }
        // The picture shows a lit term; a term of the glossary comes before what the row says of itself.
        const bool free = hovered && !ui.lighting;
        if (free && !(row.parts.empty() && explain_term(list, {at.x + indent, at.y}, text)) && !row.tip.empty())
            tooltip(row.tip);
        ImGui::PopFont();
        if (hovered && row.cell != none) ui.hovering = row.cell;
    }
    if (!command.empty()) ui.act(command);
}

}  // namespace sightline
