// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/picture2d.h"

#include <algorithm>
#include <set>

#include "core/draw/palette.h"
#include "core/draw/shown_world.h"
#include "shell/desk/compare.h"
#include "shell/desk/into.h"
#include "shell/pane/cell_words.h"
#include "shell/pane/draw_light.h"
#include "shell/pane/frozen_badge.h"
#include "shell/window/theme.h"

namespace sightline {

std::vector<MousePane> Picture2d::mouse_panes(const Area& area) {
    std::vector<MousePane> panes;
    for (std::size_t i = 0; i < sessions_.count(); ++i) {
        MousePane pane;
        pane.session = &sessions_[i];
        pane.camera.area = pane_area(area, i, sessions_.count());
        const double aspect = pane.camera.area.w / pane.camera.area.h;
        const auto held = mouse_.held_world();
        pane.camera.world = held ? *held : widened(shown_world(bench_.session), aspect);
        pane.lead = i == 0;
        pane.same_cells = i == 0 || sessions_.same_cells();
        pane.note_spots = panes_[i].spots();
        pane.strip = panes_[i].strip();
        panes.push_back(pane);
    }
    return panes;
}

void Picture2d::update(const Ui& ui, const Area& area) {
    sessions_.update(ui.revision);
    const std::vector<MousePane> panes = mouse_panes(area);
    const ShownSession<2> shown(bench_);
    if (bench_.other) {
        const std::array<std::string, 2> titles = side_titles(bench_);
        heads_ = {side_head(*shown, titles[0]).text(), side_head(sessions_[1], titles[1]).text()};
    }
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const Session<2>& session = i == 0 ? *shown : sessions_[i];
        auto options = sessions_.options<PictureOptions>(i);
        options.world = panes[i].camera.world;
        const PaneFrame frame{ui.revision, bench_.run, bench_.desk.projector, i == 0 && bench_.desk.legend,
                              bench_.desk.animate};
        panes_[i].update(ui, session, options, frame, panes[i].camera.area);
    }
}

void Picture2d::outline(const Ui& ui, const MousePane& pane, std::uint32_t cell) const {
    if (!pane.same_cells || cell >= pane.session->cells().cell_count()) return;
    const CellComplex<2>& cells = pane.session->cells();
    std::vector<ImVec2> corners;
    for (const std::uint32_t p : cells.corners_of(cell)) corners.push_back(pane.camera.to_window(cells.points[p]));
    const Colours& palette = colours(bench_.session.settings().palette);
    const float width = (bench_.desk.projector ? 1.5f : 1.0f) * ui.unit;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // Lines with round joints: the corners of slivers would grow into spikes.
    const auto ring = [&](ImU32 ink, float thickness) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            list.AddLine(corners[i], corners[(i + 1) % corners.size()], ink, thickness);
            list.AddCircleFilled(corners[i], thickness / 2, ink);
        }
    };
    ring(colour(palette.halo), 5 * width);
    ring(colour(palette.ink), 2.2f * width);
}

void Picture2d::note_cells() {
    const auto to_window = [&](const Vec<2>& p) { return std::optional(camera().to_window(p)); };
    const std::uint32_t selected = bench_.session.selected_cell, last = last_cell(bench_.session);
    note_cell(bench_, "selected cell", selected, to_window);
    note_cell(bench_, "last cell", last, to_window);
    for (const std::uint32_t cell : std::set<std::uint32_t>{selected, bench_.hovered_cell, last})
        note_cell(bench_, "cell " + std::to_string(cell), cell, to_window);
}

void Picture2d::draw_over(Ui& ui, const std::vector<MousePane>& panes, const Area& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(area.min(), area.max(), true);
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const Area& a = panes[i].camera.area;
        ImVec2 end = a.max();
        if (panes[i].strip) end.y = panes[i].camera.to_window({0, panes[i].strip_place().top}).y;  // not over its paper
        list.PushClipRect(a.min(), end, true);
        if (bench_.hovered_cell != none) outline(ui, panes[i], bench_.hovered_cell);
        if (panes[i].lead)
            draw_key_light(list, ui, *panes[i].session, bench_.lit,
                           [&](const Vec<2>& p) { return std::optional(panes[i].camera.to_window(p)); });
        list.PopClipRect();
    }
    mouse_.draw(ui, panes, area);
    for (std::size_t i = 0; i < panes.size(); ++i) {  // numbers are read, handles are only found
        const Area& a = panes[i].camera.area;
        list.PushClipRect(a.min(), a.max(), true);
        panes_[i].draw_texts(list, ui);
        list.PopClipRect();
    }
    draw_frozen_badge(list, ui, bench_, panes.front().camera.area, badge_down());
    if (bench_.other)
        for (std::size_t i = 0; i < 2; ++i) draw_head(ui, panes[i].camera.area, i);
    list.PopClipRect();
}

/// A pane that is too narrow for it gets smaller letters.
void Picture2d::draw_head(const Ui& ui, const Area& area, std::size_t side) {
    ImFont* const font = ui.fonts.bold;
    const char* const text = heads_[side].c_str();
    const float pad = 6 * ui.unit;
    float size = font->FontSize / ui.framebuffer;
    size *= std::min(1.0f, (area.w - 2 * pad) / font->CalcTextSizeA(size, 1e9f, 0, text).x);
    const ImVec2 extent = font->CalcTextSizeA(size, 1e9f, 0, text);
    const Colours& palette = colours(bench_.session.settings().palette);
    Colour paper = palette.background;
    paper.a = 225;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(area.min(), {area.x + extent.x + 2 * pad, area.y + extent.y + pad}, colour(paper));
    list.AddText(font, size, {area.x + pad, area.y + pad / 2}, colour(palette.ink), text);
    bench_.places.push_back({(side == 0 ? "head left: " : "head right: ") + heads_[side], area.x, area.y,
                             extent.x + 2 * pad, extent.y + pad});
}

void Picture2d::interact(Ui& ui, const Area& area) {
    ImGui::InvisibleButton("scene", {area.w, area.h},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
    if (!mouse_.dragging() && frozen_badge_takes_mouse(ui, bench_, mouse_panes(area).front().camera.area, badge_down()))
        mouse_.leave();
    else
        mouse_.frame(ui, mouse_panes(area));
    update(ui, area);
    draw_over(ui, mouse_panes(area), area);
    note_cells();
}

void Picture2d::draw(Ui&, const Area&) {
    for (std::size_t i = 0; i < sessions_.count(); ++i) panes_[i].draw();
}

}  // namespace sightline
