// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/picture2d.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/draw/cell_number.h"
#include "core/draw/palette.h"
#include "core/draw/shown_world.h"
#include "core/session/substep.h"
#include "shell/desk/compare.h"
#include "shell/desk/into.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// The part of the area that a pane has: all of it, or one half.
Area pane_area(const Area& area, std::size_t pane, std::size_t count) {
    if (count == 1) return area;
    constexpr float gap = 3;
    const float w = std::floor((area.w - gap) / 2);
    return {pane == 0 ? area.x : area.x + area.w - w, area.y, w, area.h};
}

}  // namespace

const Session<2>& Picture2d::session_of(std::size_t pane) const {
    return pane == 0 ? bench_.session : bench_.other->session;
}

std::vector<MousePane> Picture2d::mouse_panes(const Area& area) {
    std::vector<MousePane> panes;
    for (std::size_t i = 0; i < pane_count(); ++i) {
        MousePane pane;
        pane.session = &session_of(i);
        pane.camera.area = pane_area(area, i, pane_count());
        const double aspect = pane.camera.area.w / pane.camera.area.h;
        const auto held = mouse_.held_world();
        pane.camera.world = held ? *held : widened(shown_world(bench_.session), aspect);
        pane.lead = i == 0;
        pane.same_cells = i == 0 || !sides_.empty();
        pane.note_spots = panes_[i].spots();
        panes.push_back(pane);
    }
    return panes;
}

void Picture2d::update(const Ui& ui, const Area& area) {
    if (sides_revision_ != ui.revision) {
        sides_revision_ = ui.revision;
        sides_ = bench_.other ? projected_sides(bench_.session, bench_.other->session) : std::vector<Side>();
    }
    const std::vector<MousePane> panes = mouse_panes(area);
    const Shown<2> shown(bench_);
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const Session<2>& session = i == 0 ? *shown : session_of(i);
        const CellNumber what = session.settings().heat;
        HeatRange& heat = heat_[i];
        if (heat.run != bench_.run || heat.what != what || heat.of != &session_of(i))
            heat = {bench_.run, what, &session_of(i),
                    what == CellNumber::none ? std::nullopt : number_range(session_of(i), what)};
        PictureOptions options;
        options.heat_range = heat.range;
        options.world = panes[i].camera.world;
        options.sides = sides_;
        if (i == 0 && bench_.substep && *bench_.substep >= first_facet_substep)
            options.facet = *bench_.substep - first_facet_substep;
        panes_[i].update(ui, session, options, ui.revision, panes[i].camera.area, bench_.desk.projector,
                         i == 0 && bench_.desk.legend);
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

/// Where the cells stand that scripts and readers of the screen may ask for.
void Picture2d::note_cells() {
    const auto add = [&](const std::string& name, std::uint32_t cell) {
        if (cell >= bench_.session.cells().cell_count()) return;
        const ImVec2 at = camera().to_window(bench_.session.cells().centre(cell));
        bench_.places.push_back({name, at.x, at.y, 0, 0});
    };
    const std::uint32_t selected = bench_.session.selected_cell, last = last_cell(bench_.session);
    add("selected cell", selected);
    add("last cell", last);
    for (const std::uint32_t cell : std::set<std::uint32_t>{selected, bench_.hovered_cell, last})
        add("cell " + std::to_string(cell), cell);
}

void Picture2d::draw_over(Ui& ui, const std::vector<MousePane>& panes, const Area& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(area.min(), area.max(), true);
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const Area& a = panes[i].camera.area;
        list.PushClipRect(a.min(), a.max(), true);
        if (bench_.hovered_cell != none) outline(ui, panes[i], bench_.hovered_cell);
        list.PopClipRect();
    }
    mouse_.draw(ui, panes, area);
    for (std::size_t i = 0; i < panes.size(); ++i) {  // numbers are read, handles are only found
        const Area& a = panes[i].camera.area;
        list.PushClipRect(a.min(), a.max(), true);
        panes_[i].draw_texts(list, ui);
        list.PopClipRect();
    }
    if (bench_.other) {
        const std::array<std::string, 2> titles = side_titles(bench_);
        const std::array<const char*, 2> sides{"left: ", "right: "};
        for (std::size_t i = 0; i < 2; ++i) {
            const Area& a = panes[i].camera.area;
            const std::string title = sides[i] + titles[i];
            ImFont* const font = ui.fonts.bold;
            const float size = font->FontSize / ui.framebuffer, pad = 6 * ui.unit;
            const ImVec2 extent = font->CalcTextSizeA(size, 1e9f, 0, title.c_str());
            const Colours& palette = colours(bench_.session.settings().palette);
            Colour paper = palette.background;
            paper.a = 225;
            list.PushClipRect(a.min(), a.max(), true);
            list.AddRectFilled(a.min(), {a.x + extent.x + 2 * pad, a.y + extent.y + pad}, colour(paper));
            list.AddText(font, size, {a.x + pad, a.y + pad / 2}, colour(palette.ink), title.c_str());
            list.PopClipRect();
        }
    }
    list.PopClipRect();
}

void Picture2d::interact(Ui& ui, const Area& area) {
    ImGui::InvisibleButton("scene", {area.w, area.h},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
    mouse_.frame(ui, mouse_panes(area));
    update(ui, area);
    draw_over(ui, mouse_panes(area), area);
    note_cells();
}

void Picture2d::draw(Ui&, const Area&) {
    for (std::size_t i = 0; i < pane_count(); ++i) panes_[i].draw();
}

}  // namespace sightline
