// Rows of a panel: wrapped text, a click runs the row's command, the mouse over a row outlines its cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "core/base/glossary.h"
#include "shell/panels/id_link.h"
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

/// What of a text lies under the mouse: the text in the current font, with its line breaks, from `start` on.
struct UnderMouse {
    std::size_t line = 0, at = 0;  ///< bytes: where the line begins, and the letter in it
    float y = 0;                   ///< of the line's top
};
std::optional<UnderMouse> letter_at(const ImVec2& start, std::string_view text, const ImVec2& mouse) {
    const float size = ImGui::GetFontSize();
    UnderMouse found{0, 0, start.y};
    for (; mouse.y >= found.y + size; found.y += size) {
        const std::size_t end = text.find('\n', found.line);
        if (end == text.npos) return std::nullopt;
        found.line = end + 1;
    }
    const std::string_view line = text.substr(found.line, text.find('\n', found.line) - found.line);
    std::size_t at = 0;
    while (at < line.size() && start.x + width_of_line(line.substr(0, at + 1)) <= mouse.x) ++at;
    if (at == line.size() || mouse.x < start.x) return std::nullopt;
    found.at = found.line + at;
    return found;
}

/// Part of a line, given in bytes of the text.
void underline(ImDrawList& list, const ImVec2& start, std::string_view text, const UnderMouse& under, std::size_t first,
               std::size_t count) {
    const auto x = [&](std::size_t byte) {
        return start.x + width_of_line(text.substr(under.line, byte - under.line));
    };
    const float y = under.y + ImGui::GetFontSize();
    list.AddLine({x(first), y}, {x(first + count), y}, colour(theme::accent));
}

/// Underlines the term of the glossary that is under the mouse, and says what it means.
bool explain_term(ImDrawList& list, const ImVec2& start, std::string_view text, const UnderMouse& under) {
    const std::string_view line = text.substr(under.line, text.find('\n', under.line) - under.line);
    const TermSpot spot = term_at(line, under.at - under.line);
    if (!spot.entry) return false;
    underline(list, start, text, under, under.line + spot.first, spot.count);
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
        const bool hovered = ImGui::IsItemHovered();
        // A number that names something is a link of its own within the row.
        const auto under =
            hovered && row.parts.empty() ? letter_at({at.x + indent, at.y}, text, ImGui::GetMousePos()) : std::nullopt;
        const IdLink link = under ? id_link_at(text, under->at) : IdLink{};
        if (ImGui::IsItemClicked()) command = !link.command.empty() ? link.command : row.command;
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
        if (!link.command.empty()) underline(list, {at.x + indent, at.y}, text, *under, link.first, link.count);
        // The picture shows a lit term; a term of the glossary comes before what the row says of itself.
        const bool free = hovered && !ui.lighting;
        if (free && !(under && explain_term(list, {at.x + indent, at.y}, text, *under)) && !row.tip.empty())
            tooltip(row.tip);
        ImGui::PopFont();
        if (hovered && row.cell != none) ui.hovering = row.cell;
    }
    if (!command.empty()) ui.act(command);
}

}  // namespace sightline
