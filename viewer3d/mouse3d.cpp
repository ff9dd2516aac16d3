// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/mouse3d.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/draw/picture_3d.h"
#include "core/draw/projection.h"
#include "core/draw/shown_cells.h"
#include "core/session/explain_box.h"
#include "core/session/headline.h"
#include "core/session/missed.h"
#include "shell/commands/arguments.h"
#include "shell/desk/camera.h"
#include "shell/desk/change.h"
#include "shell/desk/conceal.h"
#include "shell/desk/fly.h"
#include "shell/desk/gesture.h"
#include "shell/desk/undo.h"
#include "shell/desk/zoom.h"
#include "shell/pane/cell_words.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// Window units, at scale 1: what a click may move, how near a handle is hit.
constexpr float click_slack = 4, handle_reach = 10;
/// Of a drag across the height of the picture.
constexpr double orbit_degrees = 180, turn_degrees = 70;
/// Of one notch of the wheel.
constexpr double wheel_factor = 1.15;

constexpr ImGuiButtonFlags any_button =
    ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle;

}  // namespace

std::optional<ImVec2> Mouse3d::handle_at(const Pane3d& pane, Drag handle) const {
    const Session<3>& s = bench_.session;
    if (!s.frozen() || s.display_view() == s.culling_view() || s.settings().show_view == Switch::off)
        return std::nullopt;
    const auto at =
        project(pane.camera(), handle == Drag::frozen_eye ? s.culling_view().eye : s.culling_view().look_at);
    if (!at) return std::nullopt;
    const ImVec2 window = pane.to_window(*at);
    return pane.area().contains(window) ? std::optional(window) : std::nullopt;
}

/// While nothing is frozen the traversal follows the eye: without a recording until the button goes up.
void Mouse3d::move_view(Ui& ui, const ViewSpec<3>& view) {
    if (view == bench_.session.display_view()) return;
    try {
        fly_to(bench_, view, "mouse");
    } catch (const InputError&) {
        return;  // a place that cannot be: the view stays
    }
    ++ui.revision;
}

void Mouse3d::press(Ui& ui, const Pane3d& pane) {
    const ImGuiIO& io = ImGui::GetIO();
    pressed_ = io.MousePos;
    before_ = begin_gesture(bench_);
    from_ = bench_.session.display_view();
    drag_ = io.MouseClicked[ImGuiMouseButton_Right]        ? Drag::turn
            : io.MouseClicked[ImGuiMouseButton_Middle]     ? Drag::pan
            : bench_.flight.on && !bench_.session.frozen() ? Drag::turn
                                                           : Drag::orbit;
    if (drag_ == Drag::orbit && io.KeyShift) drag_ = Drag::pan;
    if (!io.MouseClicked[ImGuiMouseButton_Left]) return;
    for (const Drag handle : {Drag::frozen_look, Drag::frozen_eye})
        if (const auto at = handle_at(pane, handle);
            at && std::hypot(at->x - pressed_.x, at->y - pressed_.y) <= handle_reach * ui.unit) {
            drag_ = handle;
            from_ = bench_.session.culling_view();
        }
}

void Mouse3d::drag(Ui& ui, const Pane3d& pane) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const double right = (mouse.x - pressed_.x) / pane.area().h, up = (pressed_.y - mouse.y) / pane.area().h;
    const int axis = bench_.session.scene().up_axis;
    if (drag_ == Drag::orbit) move_view(ui, orbited(from_, axis, -right * orbit_degrees, -up * orbit_degrees));
    if (drag_ == Drag::turn) move_view(ui, turned(from_, axis, right * turn_degrees, up * turn_degrees));
    if (drag_ == Drag::pan) {
        const View<3>& camera = pane.camera();
        const double height = glm::length(camera.corners[3] - camera.corners[0]);  // at the distance of look_at
        move_view(ui, walked(from_, axis, Vec<3>(-right * height, -up * height, 0)));
    }
    if (drag_ == Drag::frozen_eye || drag_ == Drag::frozen_look) {
        // In the plane through the handle that is parallel to the picture.
        const View<3>& camera = pane.camera();
        const Vec<3> at = drag_ == Drag::frozen_eye ? from_.eye : from_.look_at;
        const double scale = depth(camera, at);
        const Vec<3> across = (camera.corners[1] - camera.corners[0]) / picture_plane(camera).max.x;
        const Vec<3> by = (across * right + (camera.corners[3] - camera.corners[0]) * up) * scale;
        ViewSpec<3> view = from_;
        view.look_at += by;
        if (drag_ == Drag::frozen_eye) view.eye += by;
        try {
            change_culling_view(bench_, view, "mouse");
            ++ui.revision;
        } catch (const InputError&) {
        }
    }
}

/// The first box of a method that walks boxes, where it shows them: from outside.
std::uint32_t Mouse3d::box_under(const Pane3d& pane, const ImVec2& at) const {
    const Session<3>& session = bench_.session;
    if (!walks_boxes(session) || !seen_from_outside(session)) return none;
    const auto [from, along] = ray_through(pane.camera(), pane.to_plane(at));
    return box_along(drawn_boxes(session), from, along);
}

/// The nearest cell that is drawn as wire: one looks through it, so that what else lies there comes before it.
std::uint32_t Mouse3d::wire_under(const Pane3d& pane, const ImVec2& at) const {
    const Session<3>& session = bench_.session;
    return cell_along(session.cells(), wire_cells(session), ray_through(pane.camera(), pane.to_plane(at)));
}

/// "pixel 311,205: triangle 566 (wall41), not rendered"
std::string Mouse3d::pixel_words() const {
    const Session<3>& session = bench_.session;
    const std::uint32_t id = session.reference().image.at((*pixel_)[0], (*pixel_)[1]);
    std::string text = "pixel " + std::to_string((*pixel_)[0]) + "," + std::to_string((*pixel_)[1]) + ": ";
    if (id == none) return text + "nothing is there";
    const std::span<const Met> met = session.met();
    const bool rendered =
        std::any_of(met.begin(), met.end(), [id](const Met m) { return !m.culled() && m.primitive() == id; });
    return text + primitive_name(session.scene(), id) + (rendered ? "" : ", not rendered: a click says why");
}

/// Clicks at one place take the triangle, then the cell, and so on.
void Mouse3d::click(Ui& ui, const Pane3d& pane) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    if (!pane.area().contains(at)) return;
    const Pick3d under = pick(pane.solid(), pane.to_plane(at));
    const Tool tool = bench_.desk.tool;
    if (tool >= Tool::text) {
        const std::string anchor = under.primitive != none ? "primitive:" + std::to_string(under.primitive)
                                   : under.cell != none
                                       ? "cell:" + std::to_string(under.cell)
                                       : point_text(bench_.session.display_view().look_at, bench_.session.scene());
        field_.open_new(at, tool, anchor, tool == Tool::arrow ? "[34,26]" : "[0,14]");
        return;
    }
    std::vector<std::string> choices;
    if (const std::uint32_t node = box_under(pane, at); node != none) choices.push_back("node:" + std::to_string(node));
    if (under.cell != none) choices.push_back(std::to_string(under.cell));
    if (under.primitive != none) choices.push_back("primitive:" + std::to_string(under.primitive));
    if (const std::uint32_t wire = wire_under(pane, at); wire != none) choices.push_back(std::to_string(wire));
    ui.act("select " + cycle_.next(choices, at, click_slack * ui.unit));
}

void Mouse3d::frame(Ui& ui, std::span<const Pane3d> panes, const std::optional<std::array<int, 2>>& pixel) {
    const ImGuiIO& io = ImGui::GetIO();
    hovered_ = ImGui::IsItemHovered();
    pixel_ = pixel;
    const Pane3d* under = &panes.front();
    for (const Pane3d& pane : panes)
        if (pane.area().contains(io.MousePos)) under = &pane;
    if (hovered_ && io.MouseWheel != 0) {
        const ViewSpec<3>& view = bench_.session.display_view();
        move_view(ui, bench_.flight.on ? walked(view, bench_.session.scene().up_axis,
                                                Vec<3>(0, 0, io.MouseWheel * flight_speed(bench_) * 0.2))
                                       : approached(view, std::pow(wheel_factor, io.MouseWheel)));
        if (!bench_.flight.on) land(bench_);
    }
    if (ImGui::IsItemActivated()) {
        on_pixel_ = pixel_ && io.MouseClicked[ImGuiMouseButton_Left];
        if (!on_pixel_) press(ui, *under);
    }
    if (on_pixel_) {
        if (ImGui::IsItemActive()) return;
        on_pixel_ = false;
        if (pixel_)
            ui.act("select pixel:" + std::to_string((*pixel_)[0]) + "," + std::to_string((*pixel_)[1]) + "; show why");
        return;
    }
    if (drag_ != Drag::none && ImGui::IsItemActive()) {
        if (std::hypot(io.MousePos.x - pressed_.x, io.MousePos.y - pressed_.y) > click_slack * ui.unit)
            drag(ui, *under);
    } else if (drag_ != Drag::none) {
        const bool still = std::hypot(io.MousePos.x - pressed_.x, io.MousePos.y - pressed_.y) <= click_slack * ui.unit;
        drag_ = Drag::none;
        before_.reset();
        end_gesture(bench_);
        if (!bench_.flight.on) land(bench_);
        ++ui.revision;
        if (still && io.MouseReleased[ImGuiMouseButton_Left]) click(ui, *under);
    }
}

bool Mouse3d::cancel() {
    if (field_.close()) return true;
    if (drag_ == Drag::none) return false;
    drag_ = Drag::none;
    cancel_gesture(bench_, std::move(*before_));
    before_.reset();
    return true;
}

void Mouse3d::tooltip(Ui& ui, const Pane3d& pane) {
    if (!hovered_ || !ui.mouse_awake || drag_ != Drag::none || field_.is_open() || bench_.session.flying()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (pixel_) {
        if (!tells_truth(bench_.session) || asks_for_cell(bench_)) return;
        ImGui::SetNextWindowPos({mouse.x + 18 * ui.unit, mouse.y + 18 * ui.unit});
        ImGui::SetTooltip("%s", pixel_words().c_str());
        return;
    }
    if (!pane.area().contains(mouse)) return;
    const Pick3d under = pick(pane.solid(), pane.to_plane(mouse));
    const std::uint32_t node = box_under(pane, mouse);
    if (!under.hits() && node == none) return;
    if (under.cell != none) ui.hovering = under.cell;
    if (asks_for_cell(bench_)) return;
    const Scene<3>& scene = bench_.session.scene();
    std::string text = node != none         ? conceal(bench_, box_sentence(bench_.session, node))
                       : under.cell != none ? conceal(bench_, cell_words(bench_.session, under.cell))
                                            : primitive_name(scene, under.primitive);
    if (under.cell != none && under.primitive != none && !scene.objects.empty())
        text = primitive_name(scene, under.primitive) + "\n" + text;
    ImGui::SetNextWindowPos({mouse.x + 18 * ui.unit, mouse.y + 18 * ui.unit});
    ImGui::SetTooltip("%s", text.c_str());
}

void Mouse3d::draw(Ui& ui, std::span<const Pane3d> panes, const Area& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Pane3d& lead = panes.front();
    for (const Drag handle : {Drag::frozen_eye, Drag::frozen_look}) {
        const auto at = handle_at(lead, handle);
        if (!at) continue;
        const bool lit = drag_ == handle;
        list.AddCircleFilled(*at, 6 * ui.unit, lit ? colour(theme::accent) : IM_COL32_WHITE);
        list.AddCircle(*at, 6 * ui.unit, colour(theme::ink), 0, 1.5f * ui.unit);
        bench_.places.push_back({handle == Drag::frozen_eye ? "frozen eye" : "frozen look", at->x, at->y, 0, 0});
    }
    tooltip(ui, lead);
    field_.draw(ui, area);
    ui.awaits_text = field_.is_open();
}

}  // namespace sightline
