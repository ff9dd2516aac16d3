// A column of the window: its panels in groups, and the panel that is chosen.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "shell/window/button_row.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// The groups, and the panels of the one that is open; a click on the open one closes the column.
template <int D>
void tabs(Ui& ui, Workbench<D>& bench, Column side, const Panel<D>& shown) {
    const auto click = [&](const Panel<D>& panel) { ui.act("show " + std::string(panel.id)); };
    if (side == Column::right) {
        ImGui::PushFont(ui.fonts.bold);
        ButtonRow groups(3 * ui.unit);
        for (std::size_t g = 0; g < panel_group_titles.size(); ++g) {
            const std::string title(panel_group_titles[g]);
            const bool open = static_cast<std::size_t>(shown.group) == g;
            const bool pressed = groups.add(title, open);
            note_place(bench, "group " + title);
            if (!pressed) continue;
            const auto table = panel_table<D>();
            click(open ? shown : *std::find_if(table.begin(), table.end(), [&](const Panel<D>& panel) {
                return static_cast<std::size_t>(panel.group) == g;
            }));
        }
        ImGui::PopFont();
    }
    ButtonRow row(3 * ui.unit);
    for (const Panel<D>& panel : panel_table<D>()) {
        const bool here = panel.group == shown.group && (side == Column::right || panel.column == side);
        if (!here) continue;
        if (row.add(std::string(panel.title), panel.id == shown.id)) click(panel);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(panel.text).c_str());
        if (panel.column == side) note_place(bench, "tab " + std::string(panel.id));
    }
}

template <int D>
const std::vector<Row>& rows_of(Ui& ui, const Workbench<D>& bench, Column side, const Panel<D>& panel) {
    ShownRows& shown = ui.columns[static_cast<std::size_t>(side)];
    if (shown.revision != ui.revision || shown.panel != panel.id)
        shown = {std::string(panel.id), ui.revision, panel_rows(panel, bench)};
    return shown.rows;
}

}  // namespace

template <int D>
void panel_column(Ui& ui, Workbench<D>& bench, Column side, const Area& area) {
    const Desk& desk = bench.desk;
    const std::string shown = desk.projector ? desk.projector_panel : side == Column::left ? desk.left : desk.right;
    begin_part(side == Column::left ? "left" : "right", area);
    if (const Panel<D>* panel = find_panel<D>(shown)) {
        if (!desk.projector) {
            tabs(ui, bench, side, *panel);
            ImGui::Separator();
        }
        if (panel->body == Body::chart) trade_off_chart(ui, bench);
        ImGui::BeginChild(shown.c_str());
        if (panel->body == Body::widgets)
            settings_widgets(ui, bench);
        else if (panel->body == Body::chart)  // changes while the bench does not
            draw_rows(ui, panel_rows(*panel, bench), bench.hovered_cell);
        else
            draw_rows(ui, rows_of(ui, bench, side, *panel), bench.hovered_cell);
        ImGui::EndChild();
    }
    ImGui::End();
}

template void panel_column<2>(Ui&, Workbench<2>&, Column, const Area&);
template void panel_column<3>(Ui&, Workbench<3>&, Column, const Area&);

}  // namespace sightline
