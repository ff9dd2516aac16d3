// The parts that the window is made of. Each draws itself into its area and runs commands.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"
#include "shell/panels/panel.h"
#include "shell/window/stage.h"
#include "shell/window/ui.h"

namespace sightline {

/// The command table as menus. Returns its height.
template <int D>
float menu_bar(Ui& ui, Workbench<D>& bench);

/// What is shown, and buttons for what a person may want next.
template <int D>
void title_line(Ui& ui, Workbench<D>& bench, const Area& area);

/// Play, step, and a slim curve of what is found, with the place in the run.
template <int D>
void scrubber(Ui& ui, Workbench<D>& bench, const Area& area);

/// The flight path: which, where in it, replay, record and save.
template <int D>
void path_bar(Ui& ui, Workbench<D>& bench, const Area& area);

/// The last message, and what the keys do here.
template <int D>
void status_line(Ui& ui, Workbench<D>& bench, const Area& area);

/// Tabs and rows of the panel that the desk shows on this side.
template <int D>
void panel_column(Ui& ui, Workbench<D>& bench, Column side, const Area& area);

/// The rows of a panel as they are; those about the hovered cell stand out.
void draw_rows(Ui& ui, const std::vector<Row>& rows, std::uint32_t hovered_cell);

/// The settings panel: a widget per row of the settings table, and the presets.
template <int D>
void settings_widgets(Ui& ui, Workbench<D>& bench);

/// The chart over the rows of the trade-off panel.
template <int D>
void trade_off_chart(Ui& ui, Workbench<D>& bench);

/// The lanes of the recorded run.
template <int D>
void timeline(Ui& ui, Workbench<D>& bench, const Area& area);

/// Scene chooser, help sheet and console, where the desk shows them.
template <int D>
void overlays(Ui& ui, Workbench<D>& bench, const Stage& stage, const Area& area);

/// Closes one thing, the one in front: a menu or a list that has dropped down, the console, a sheet. False: there is
/// none.
bool close_topmost(Desk& desk);

/// The scenes to choose from; takes the keyboard.
template <int D>
void scene_chooser(Ui& ui, Workbench<D>& bench, const Stage& stage, const Area& area);

/// All keys with what they do.
template <int D>
void help_sheet(Ui& ui, const Area& area);

/// What the banner says in projector mode: the result so far, the step, and how its key came about.
template <int D>
std::vector<Row> banner_lines(const Workbench<D>& bench);

/// Lines of text for a class, wrapped to the width; where they are higher than `most` they are written smaller.
float block_height(ImFont* font, const std::vector<Row>& lines, float width, float most);
template <int D>
void text_block(Workbench<D>& bench, const char* name, ImFont* font, const std::vector<Row>& lines, const Area& area);

/// The lessons with their parts, to choose from.
template <int D>
void lesson_sheet(Ui& ui, Workbench<D>& bench, const Area& area);

/// Begins an ImGui window without decoration that covers the area; end it with ImGui::End.
void begin_part(const char* name, const Area& area, ImGuiWindowFlags flags = 0);

/// The same over the picture, in front of everything, with a scroll bar where it needs one.
void begin_overlay(const char* name, const Area& area);

/// Notes where the last item stands, for the text dump and for scripts.
template <int D>
void note_place(Workbench<D>& bench, const std::string& name) {
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    bench.places.push_back({name, a.x, a.y, b.x - a.x, b.y - a.y});
}

}  // namespace sightline
