// The lines at the edges: the last message, and the formula of the projector mode.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/base/number.h"
#include "core/session/explain.h"
#include "core/session/substep.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

template <int D>
void status_line(Ui& ui, Workbench<D>& bench, const Area& area) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * ui.unit, 3 * ui.unit});
    begin_part("status", area);
    ImGui::PopStyleVar();
    if (ui.messages.empty()) {
        ImGui::TextDisabled("%sRight: next step   Left: back   Space: play   F1: all keys   Type : for a command",
                            D == 3 ? "G: fly   F: freeze here   Z: exact image   " : "");
    } else {
        const Message& message = ui.messages.back();
        ImGui::PushStyleColor(ImGuiCol_Text, colour(message.bad ? theme::bad : theme::ink));
        ImGui::TextUnformatted(message.text.c_str());
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", message.text.c_str());
    }
    if (bench.desk.tool != Tool::select) {
        const std::string text =
            "tool: " + std::string(tool_words[static_cast<std::size_t>(bench.desk.tool)]) + " (V: select)";
        ImGui::SameLine(area.w - ImGui::CalcTextSize(text.c_str()).x - 12 * ui.unit);
        ImGui::TextUnformatted(text.c_str());
    }
    ImGui::End();
}

float banner_height(const Ui& ui) { return ui.fonts.banner->FontSize / ui.framebuffer * 1.25f * 2 + 14 * ui.unit; }

namespace {

std::string banner_step(const StepExplanation& step) {
    std::string text = "Step " + std::to_string(step.step);
    if (step.cell != none) {
        text += ": cell " + std::to_string(step.cell) + ", key " + short_number(step.key, step.digits);
        if (step.runner_up == none)
            text += ", alone in the front";
        else if (step.runner_up_key == step.key)
            text += "; runner-up cell " + std::to_string(step.runner_up) + ": tie, older stamp wins";
        else
            text += "; runner-up cell " + std::to_string(step.runner_up) + ", key " +
                    short_number(step.runner_up_key, step.digits);
    }
    return text + "; " + std::to_string(step.rendered) + " rendered, " + std::to_string(step.visible) + " visible";
}

/// How the key came about: of the facet that step into stands at, else of the cell just projected.
template <int D>
std::string banner_formula(const Workbench<D>& bench, const StepExplanation& step) {
    const Session<D>& session = bench.session;
    const auto shown = bench.substep ? shown_in_substep(session, step.step, *bench.substep) : std::nullopt;
    if (shown) {
        const Considered& c = step.looked_at[*shown];
        if (!c.item) return "across this facet: the border";
        return item_name(c.item) + ": " + (c.key ? c.key->formula() : std::string(c.words));
    }
    if (step.cell == none) return "";
    const CellExplanation cell = explain_cell(session, step.cell);
    if (cell.chain.empty() || !cell.chain.back().update.key) return "its key is that of a seed";
    const ChainLink& link = cell.chain.back();
    return "its key, from " + item_name(link.update.from) + " in step " + std::to_string(link.step) + ": " +
           link.update.key->formula();
}

}  // namespace

template <int D>
void projector_banner(Ui& ui, Workbench<D>& bench, const Area& area) {
    begin_part("banner", area);
    ImGui::PushFont(ui.fonts.banner);
    const Session<D>& s = bench.session;
    if (s.flying()) {
        ImGui::TextWrapped("Flying: %s runs in each frame within its budget. F freezes this one.",
                           std::string(s.method().title).c_str());
    } else if (s.position() == 0) {
        ImGui::TextWrapped("Step 0 of %u: the seed cell is in the front, nothing is projected yet.", s.recorded());
    } else {
        const StepExplanation step = explain_step(s, s.position());
        const std::array lines{banner_step(step), banner_formula(bench, step)};
        float widest = 1;
        for (const std::string& line : lines) widest = std::max(widest, ImGui::CalcTextSize(line.c_str()).x);
        ImGui::SetWindowFontScale(std::min(1.0f, ImGui::GetContentRegionAvail().x / widest));
        for (const std::string& line : lines) ImGui::TextUnformatted(line.c_str());
    }
    ImGui::PopFont();
    ImGui::End();
}

template void status_line<2>(Ui&, Workbench<2>&, const Area&);
template void status_line<3>(Ui&, Workbench<3>&, const Area&);
template void projector_banner<2>(Ui&, Workbench<2>&, const Area&);
template void projector_banner<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
