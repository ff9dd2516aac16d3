// A column of the window: the tabs of its panels, and the panel that is chosen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Tabs that wrap; a click on the open one closes the column.
template <int D>
void tabs(Ui& ui, Workbench<D>& bench, Column side, const std::string& shown) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
    bool first = true;
    for (const Panel<D>& panel : panel_table<D>()) {
        if (panel.column != side) continue;
        const std::string title(panel.title);
        const float w = ImGui::CalcTextSize(title.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
        if (!first && ImGui::GetItemRectMax().x + 3 * ui.unit + w < right) ImGui::SameLine(0, 3 * ui.unit);
        first = false;
        const bool open = panel.id == shown;
        if (open) ImGui::PushStyleColor(ImGuiCol_Button, colour(theme::hover));
        if (ImGui::Button(title.c_str())) ui.act("show " + std::string(panel.id));
        if (open) ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(panel.text).c_str());
        note_place(bench, "tab " + std::string(panel.id));
    }
}

template <int D>
const std::vector<Row>& rows_of(Ui& ui, const Workbench<D>& bench, Column side, const Panel<D>& panel) {
    ShownRows& shown = ui.columns[static_cast<std::size_t>(side)];
    if (shown.revision != ui.revision || shown.panel != panel.id)
        shown = {std::string(panel.id), ui.revision, panel.rows(bench)};
    return shown.rows;
}

}  // namespace

template <int D>
void panel_column(Ui& ui, Workbench<D>& bench, Column side, const Area& area) {
    const std::string shown = side == Column::left ? bench.desk.left : bench.desk.right;
    begin_part(side == Column::left ? "left" : "right", area);
    tabs(ui, bench, side, shown);
    ImGui::Separator();
    if (const Panel<D>* panel = find_panel<D>(shown)) {
        if (panel->body == Body::chart) trade_off_chart(ui, bench);
        ImGui::BeginChild(shown.c_str());
        if (panel->body == Body::widgets)
            settings_widgets(ui, bench);
        else if (panel->body == Body::chart)  // changes while the bench does not
            draw_rows(ui, panel->rows(bench), bench.hovered_cell);
        else
            draw_rows(ui, rows_of(ui, bench, side, *panel), bench.hovered_cell);
        ImGui::EndChild();
    }
    ImGui::End();
}

template void panel_column<2>(Ui&, Workbench<2>&, Column, const Area&);
template void panel_column<3>(Ui&, Workbench<3>&, Column, const Area&);

}  // namespace sightline
