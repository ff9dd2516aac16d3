// The mouse on the 2D picture: hover, select, drag the view, pan, zoom.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/number.h"
#include "shell/bench/change.h"
#include "shell/window/theme.h"
#include "viewer2d/picture2d.h"

namespace sightline {

namespace {

constexpr float drag_threshold = 4;

std::string cell_tip(const Session<2>& session, std::uint32_t cell) {
    const CellMark mark = session.state().mark(cell);
    std::string text =
        "cell " + std::to_string(cell) + ", " + std::string(cell_state_words[static_cast<std::size_t>(mark.state)]);
    if (mark.state == CellState::enqueued || mark.state == CellState::projected)
        text += ", ρ " + short_number(mark.key);
    return text + ", |A| " + std::to_string(session.cells().count(cell)) + ", visible share " +
           short_number(session.reference().cell_share[cell]);
}

}  // namespace

void Picture2d::zoom_at(Ui& ui, const ImVec2& mouse, double factor) {
    Settings settings = bench_.session.settings();
    const double zoom = std::clamp(settings.zoom * factor, 0.1, 1000.0);
    const Vec<2> fixed = camera_.to_scene(mouse), centre = camera_.world.centre();
    const Vec<2> to = fixed + (centre - fixed) * (settings.zoom / zoom);
    settings.zoom = zoom;
    settings.zoom_at = ZoomAt::point;
    settings.zoom_x = to.x;
    settings.zoom_y = to.y;
    change_settings(bench_, settings, "zoom");
    ++ui.revision;
}

void Picture2d::drag_on(Ui& ui) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Camera start{drag_->world, camera_.area};
    const Vec<2> by = start.to_scene(mouse) - start.to_scene(drag_->from);
    if (drag_->pans) {
        Settings settings = bench_.session.settings();
        const Vec<2> centre = drag_->world.centre() - by;
        settings.zoom_at = ZoomAt::point;
        settings.zoom_x = centre.x;
        settings.zoom_y = centre.y;
        change_settings(bench_, settings, "pan");
    } else {
        ViewSpec<2> view = drag_->view;
        if (drag_->handle == Handle::eye) {
            view.eye += by;
            view.look_at += by;
        } else {
            view.look_at = camera_.to_scene(mouse);
        }
        if (view == bench_.session.display_view() || view.eye == view.look_at) return;
        change_view(bench_, view, "drag");
    }
    ++ui.revision;
}

bool Picture2d::cancel() {
    if (!drag_) return false;
    undo(bench_);
    drag_.reset();
    return true;
}

void Picture2d::click(Ui& ui, const Pick& under) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool again = std::hypot(mouse.x - last_click_.x, mouse.y - last_click_.y) < drag_threshold * ui.unit;
    clicks_ = again ? clicks_ + 1 : 0;
    last_click_ = mouse;
    std::vector<std::string> here;
    if (under.primitive != none) here.push_back("select primitive:" + std::to_string(under.primitive));
    if (under.cell != none) here.push_back("select " + std::to_string(under.cell));
    if (here.empty()) return ui.act("select none");
    ui.act(here[static_cast<std::size_t>(clicks_) % here.size()]);
}

void Picture2d::draw_hover(Ui& ui, const Pick& under) {
    bench_.hovered_cell = under.cell;
    if (under.cell == none || drag_) return;
    ImGui::SetTooltip("%s", cell_tip(bench_.session, under.cell).c_str());
    (void)ui;
}

void Picture2d::mouse(Ui& ui, const Pick& under) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel != 0) zoom_at(ui, io.MousePos, std::pow(1.2, io.MouseWheel));
    if (ImGui::IsItemActivated()) {
        drag_ =
            Drag{under.handle, under.handle == Handle::none, io.MousePos, bench_.session.display_view(), camera_.world};
        end_gesture(bench_);
    }
    const bool dragging = ImGui::IsMouseDragging(ImGuiMouseButton_Left, drag_threshold * ui.unit);
    if (drag_ && ImGui::IsItemActive() && dragging) drag_on(ui);
    if (ImGui::IsItemDeactivated() && drag_) {
        const bool clicked = io.MouseDragMaxDistanceSqr[0] < drag_threshold * drag_threshold * ui.unit * ui.unit;
        drag_.reset();
        end_gesture(bench_);
        if (clicked) click(ui, under);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && under.cell != none)
        ui.act("reach " + std::to_string(under.cell));
}

void Picture2d::interact(Ui& ui, const Area& area) {
    camera_.area = area;
    if (camera_.world.empty()) return;  // before the first frame
    ImGui::InvisibleButton("scene", {area.w, area.h});
    const Pick under = pick(bench_.session, camera_, ImGui::GetIO().MousePos, ui.unit);
    if (ImGui::IsItemHovered() || drag_) mouse(ui, under);
    if (ImGui::IsItemHovered()) draw_hover(ui, under);
    draw_labels(ui);
    const ImVec2 eye = camera_.to_window(bench_.session.display_view().eye);
    const ImVec2 look = look_handle(bench_.session.display_view(), camera_, ui.unit);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(look, 5 * ui.unit, IM_COL32_WHITE);
    list.AddCircle(look, 5 * ui.unit, colour(theme::ink), 0, 1.5f * ui.unit);
    bench_.places.push_back({"handle eye", eye.x, eye.y, 0, 0});
    bench_.places.push_back({"handle look", look.x, look.y, 0, 0});
}

}  // namespace sightline
