// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer2d/mouse2d.h"

#include <cmath>
#include <utility>

#include "core/draw/notes.h"
#include "core/draw/palette.h"
#include "core/session/explain_box.h"
#include "core/session/missed.h"
#include "shell/commands/arguments.h"
#include "shell/desk/conceal.h"
#include "shell/desk/edit.h"
#include "shell/desk/gesture.h"
#include "shell/desk/undo.h"
#include "shell/desk/zoom.h"
#include "shell/pane/cell_words.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

constexpr float drag_threshold = 4;

bool is_note_tool(Tool tool) { return tool >= Tool::text; }

/// Where a new note's text stands from its anchor, in points: an arrow needs room for its line.
const char* first_offset(Tool tool) {
    if (tool == Tool::arrow) return "[34,26]";
    return tool == Tool::ring ? "[0,16]" : "[0,12]";
}

}  // namespace

std::vector<Mouse2d::ShownNote> Mouse2d::shown_notes(const MousePane& pane) const {
    std::vector<ShownNote> shown;
    if (!pane.lead) return shown;
    const Session<2>& session = bench_.session;
    std::size_t label = 0;
    for (std::uint32_t i = 0; i < session.notes.size(); ++i) {
        const Note<2>& note = session.notes[i];
        if (session.position() < note.first_step || session.position() > note.last_step) continue;
        for (const LabelSpot& spot : pane.note_spots)
            if (spot.label == label) shown.push_back({i, &spot});
        ++label;
    }
    return shown;
}

void Mouse2d::look_under(Ui& ui, std::span<const MousePane> panes) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    pane_.reset();
    pick_ = {};
    note_ = none;
    on_paper_ = false;
    strip_.reset();
    handles_.clear();
    for (const MousePane& pane : panes)
        if (pane.camera.area.contains(mouse)) pane_ = pane;
    if (!pane_) return;
    if (pane_->strip) look_at_strip(pane_->camera.to_scene(mouse));
    handles_ = shown_handles(*pane_, ui.unit);
    const std::vector<ShownNote> notes = shown_notes(*pane_);
    for (const ShownNote& shown : notes)
        if (shown.note == bench_.selected_note) handles_.push_back({Handle::note_anchor, shown.spot->anchor});
    const bool grips = edit_mode(*pane_, ui.unit).on && bench_.desk.tool == Tool::select;
    pick_ = pick(*pane_->session, pane_->camera, handles_, mouse, ui.unit, grips);
    if (on_paper_) pick_ = {pick_.handle == Handle::note_anchor ? Handle::note_anchor : Handle::none};
    if (pick_.handle == Handle::note_anchor) note_ = bench_.selected_note;
    if (pick_.handle != Handle::none) return;
    for (const ShownNote& shown : notes)
        if (shown.spot->box.contains(mouse)) {
            pick_.handle = Handle::note_text;
            note_ = shown.note;
        }
}

void Mouse2d::look_at_strip(const Vec<2>& mouse) {
    const EyeStripPlace place = pane_->strip_place();
    on_paper_ = mouse.y < place.top;
    if (on_paper_) strip_ = pick_strip(*pane_->strip, place, mouse);
}

EditMode Mouse2d::edit_mode(const MousePane& pane, float unit) const {
    if (!bench_.desk.edit || !pane.lead) return {};
    if (drag_) return {true, drag_->segment};
    const bool here = pane_ && pane_->session == pane.session;
    return {true, here ? segment_near(*pane.session, pane.camera, ImGui::GetIO().MousePos, unit) : none};
}

/// Those that can be seen: the bench's own, or those of the same view, and none under the strip's paper.
std::vector<HandlePoint> Mouse2d::shown_handles(const MousePane& pane, float unit) const {
    std::vector<HandlePoint> points;
    if (pane.lead || pane.session->culling_view() == bench_.session.culling_view())
        points = handle_points(bench_.session, pane.camera, unit, edit_mode(pane, unit));
    if (bench_.desk.tool != Tool::select)  // its clicks are for what it makes
        std::erase_if(points, [](const HandlePoint& point) { return point.handle >= Handle::segment_start; });
    std::erase_if(points, [&](const HandlePoint& point) {
        const bool covered = pane.strip && pane.camera.to_scene(point.at).y < pane.strip_place().top;
        return covered || (!pane.lead && point.handle >= Handle::segment_start);
    });
    return points;
}

void Mouse2d::wheel(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel == 0 || io.KeyCtrl || drag_) return;
    zoom_about(bench_, pane_->camera.to_scene(io.MousePos), std::pow(1.2, io.MouseWheel), "zoom");
    ++ui.revision;
}

void Mouse2d::press(Ui&) {
    pressed_run_ = bench_.run;
    const ImGuiIO& io = ImGui::GetIO();
    Drag drag{DragKind::pan, Handle::none,         none, pane_->camera.to_scene(io.MousePos),
              pane_->camera, begin_gesture(bench_)};
    if (io.MouseClicked[ImGuiMouseButton_Left]) {
        drag.handle = pick_.handle;
        drag.note = note_;
        drag.segment = pick_.segment;
        const bool cuts = bench_.desk.tool == Tool::gap && pane_->lead && pick_.primitive != none;
        if (cuts && drag.handle == Handle::none) drag.segment = pick_.primitive;
        if (drag.handle != Handle::none)
            drag.kind = DragKind::handle;
        else if (cuts)
            drag.kind = DragKind::cut_gap;
        else if (bench_.desk.tool == Tool::segment && pane_->lead)
            drag.kind = DragKind::draw_segment;
    }
    drag_ = std::move(drag);
}

void Mouse2d::place_note(Ui& ui) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Session<2>& session = bench_.session;
    const Vec<2> at = pane_->camera.to_scene(mouse);
    const std::uint32_t cell = centre_near(session, pane_->camera, at, ui.unit);
    const std::string anchor = cell != none ? "cell:" + std::to_string(cell) : point_text(at, session.scene());
    field_.open_new(mouse, bench_.desk.tool, anchor, first_offset(bench_.desk.tool));
}

void Mouse2d::edit_note(std::uint32_t index, const ImVec2& at) {
    const Note<2>& note = bench_.session.notes[index];
    field_.open(at, "note-edit " + std::to_string(index + 1), "", note.text, note.first_step, note.last_step);
}

void Mouse2d::click(Ui& ui) {
    if (!pane_) return;
    if (note_ != none) {
        cycle_.forget();
        return ui.act("select note:" + std::to_string(note_ + 1));
    }
    if (is_note_tool(bench_.desk.tool) && pane_->lead) return place_note(ui);
    if (on_paper_ && pick_.handle == Handle::none) return click_strip(ui);
    if (bench_.desk.tool == Tool::gap && pane_->lead) return click_gap(ui);
    // A handle is there to be dragged; only a segment lies on what can be selected.
    if (pick_.handle != Handle::none && pick_.handle < Handle::segment_start) return;
    Pick under = pick_;
    if (!pane_->same_cells) under.cell = none;
    if (!pane_->lead && pane_->session->traversal().boxes() != bench_.session.traversal().boxes()) under.node = none;
    if (!pane_->lead || (asks_for_cell(bench_) && under.cell != none)) under.primitive = none;
    ui.act("select " + cycle_.next(choices(under), ImGui::GetIO().MousePos, drag_threshold * ui.unit));
}

/// Two clicks on one segment take away what lies between them.
void Mouse2d::click_gap(Ui& ui) {
    const std::uint32_t segment = pick_.primitive;
    const std::shared_ptr<const Scene<2>> scene = bench_.session.shared_scene();
    if (segment == none) {
        gap_.reset();
        return bench_.say("a gap begins on a wall: click it, or drag along it");
    }
    const Vec<2> at = pane_->camera.to_scene(ImGui::GetIO().MousePos);
    if (!gap_ || gap_->of != scene || gap_->segment != segment) {
        const bool other = gap_ && gap_->of == scene;
        gap_ = GapStart{segment, nearest_on(scene->primitives[segment], at), scene};
        ui.act("select primitive:" + std::to_string(segment));
        return bench_.say(std::string(other ? "this is another segment: the gap begins here; " : "") +
                          "now click where it ends, on the same segment");
    }
    const GapStart from = *std::exchange(gap_, std::nullopt);
    ui.act("segment cut " + std::to_string(segment) + " " + point_text(from.at, *scene) + " " + point_text(at, *scene));
}

/// The segment that the band shows, where the bench has the same ones.
void Mouse2d::click_strip(Ui& ui) {
    cycle_.forget();
    const bool same_scene = pane_->session->shared_scene() == bench_.session.shared_scene();
    if (strip_ && strip_->primitive() != none && same_scene)
        ui.act("select primitive:" + std::to_string(strip_->primitive()));
}

void Mouse2d::double_click(Ui& ui) {
    if (!pane_) return;
    if (note_ != none) return edit_note(note_, ImGui::GetIO().MousePos);
    const bool on_view = pick_.handle != Handle::none && pick_.handle < Handle::segment_start;
    if (on_view || pick_.cell == none || !pane_->same_cells || bench_.desk.tool != Tool::select) return;
    // The first click may have taken the segment, or gone on in the cycle.
    cycle_.forget();
    const std::string cell = std::to_string(pick_.cell);
    ui.act("select " + cell + "; reach " + cell);
}

void Mouse2d::release(Ui& ui, bool clicked) {
    drag_.reset();
    end_gesture(bench_);
    // What was pressed on may be gone: a key can change the cells in between.
    if (clicked && !swallow_click_ && pressed_run_ == bench_.run) click(ui);
    swallow_click_ = false;
}

void Mouse2d::frame(Ui& ui, std::span<const MousePane> panes) {
    const ImGuiIO& io = ImGui::GetIO();
    hovered_ = ImGui::IsItemHovered();
    look_under(ui, panes);
    if (hovered_ && pane_) wheel(ui);
    if (ImGui::IsItemActivated() && pane_) {
        const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        press(ui);
        if (twice) {
            swallow_click_ = true;
            double_click(ui);
        }
    }
    if (drag_ && ImGui::IsItemActive()) {
        const int button = io.MouseDown[ImGuiMouseButton_Left] ? ImGuiMouseButton_Left : ImGuiMouseButton_Middle;
        if (ImGui::IsMouseDragging(button, drag_threshold * ui.unit)) {
            drag_to(bench_, *drag_, io.MousePos, ui.unit);
            ++ui.revision;
        }
    }
    // Also when something else took the mouse away, such as the field that a double click opens.
    if (drag_ && !ImGui::IsItemActive()) {
        const float moved = drag_threshold * ui.unit;
        release(ui, io.MouseReleased[ImGuiMouseButton_Left] && io.MouseDragMaxDistanceSqr[0] < moved * moved);
    }
    if (hovered_ && ui.mouse_awake && !drag_ && pane_ && pane_->same_cells) ui.hovering = pick_.cell;
}

bool Mouse2d::cancel() {
    if (field_.close()) return true;
    if (!drag_) return std::exchange(gap_, std::nullopt).has_value();
    cancel_gesture(bench_, std::move(drag_->before));
    drag_.reset();
    return true;
}

std::optional<Box<2>> Mouse2d::held_world() const {
    if (!drag_ || drag_->kind == DragKind::pan) return std::nullopt;
    return drag_->camera.world;
}

void Mouse2d::draw_handles(Ui& ui, const MousePane& pane) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float size = (bench_.desk.projector ? 1.6f : 1.0f) * ui.unit;
    for (const HandlePoint& point : shown_handles(pane, ui.unit)) {
        const Handle held = drag_ ? drag_->handle : hovered_ ? pick_.handle : Handle::none;
        const bool lit = held == point.handle && (drag_ ? drag_->segment : pick_.segment) == point.segment;
        if (pane.lead) bench_.places.push_back({handle_name(point.handle), point.at.x, point.at.y, 0, 0});
        const bool eye = point.handle == Handle::eye || point.handle == Handle::frozen_eye;
        if (eye && !lit) continue;  // the picture has a mark there
        const bool opening = point.handle == Handle::opening || point.handle == Handle::frozen_opening;
        const bool frozen = point.handle >= Handle::frozen_eye && point.handle <= Handle::frozen_opening;
        const float r = (eye ? 8.0f : opening ? 4.0f : 5.5f) * size;
        const ImU32 fill = lit ? colour(theme::accent) : frozen ? IM_COL32(205, 205, 205, 255) : IM_COL32_WHITE;
        if (eye) {
            list.AddCircle(point.at, r, IM_COL32_WHITE, 0, 4 * size);
            list.AddCircle(point.at, r, fill, 0, 2 * size);
        } else {
            list.AddCircleFilled(point.at, r, fill);
            list.AddCircle(point.at, r, colour(theme::ink), 0, 1.5f * size);
        }
    }
    for (const ShownNote& shown : shown_notes(pane)) {
        const Area& b = shown.spot->box;
        bench_.places.push_back({"note " + std::to_string(shown.note + 1), b.x, b.y, b.w, b.h});
        if (shown.note != bench_.selected_note) continue;
        const ImVec2 min{b.x - 3 * size, b.y - 3 * size}, max{b.x + b.w + 3 * size, b.y + b.h + 3 * size};
        list.AddRect(min, max, colour(theme::accent), 3 * size, 0, 1.5f * size);
        list.AddCircleFilled(shown.spot->anchor, 4 * size, IM_COL32_WHITE);
        list.AddCircle(shown.spot->anchor, 4 * size, colour(theme::accent), 0, 1.5f * size);
    }
}

/// The line of sight of the pixel under the mouse, and where the bands stand, for scripts.
void Mouse2d::draw_strip(Ui& ui, const MousePane& pane) {
    if (!pane.strip) return;
    const EyeStripPlace place = pane.strip_place();
    if (strip_ && hovered_ && ui.mouse_awake && !drag_ && pane_->session == pane.session) {
        const auto sight = line_of_sight(*pane.session, *pane.strip, *strip_, 4 * pane.camera.world.longest_side());
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 from = pane.camera.to_window(sight[0]), to = pane.camera.to_window(sight[1]);
        const Area& area = pane.camera.area;
        list.PushClipRect(area.min(), {area.x + area.w, pane.camera.to_window({0, place.top}).y}, true);
        list.AddLine(from, to, IM_COL32_WHITE, 4 * ui.unit);
        list.AddLine(from, to, colour(theme::accent), 2 * ui.unit);
        if (strip_->primitive() != none) list.AddCircleFilled(to, 5 * ui.unit, colour(theme::accent));
        list.PopClipRect();
    }
    const auto note = [&](const char* name, double low, double high) {
        const ImVec2 a = pane.camera.to_window({place.left, high}), b = pane.camera.to_window({place.right, low});
        bench_.places.push_back({name, a.x, a.y, b.x - a.x, b.y - a.y});
    };
    if (!pane.lead) return;
    note("strip exact", place.exact_low, place.exact_high);
    note("strip drawn", place.drawn_low, place.drawn_high);
}

/// Where a gap would begin, or what it would take away; and a frame, so that nobody edits without knowing.
void Mouse2d::draw_gap(Ui& ui, const MousePane& pane) {
    if (!bench_.desk.edit || !pane.lead) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Area& area = pane.camera.area;
    const float unit = ui.unit;
    list.AddRect({area.x + unit, area.y + unit}, {area.x + area.w - unit, area.y + area.h - unit},
                 colour(theme::accent), 0, 0, 3 * unit);
    if (bench_.desk.tool != Tool::gap || drag_) return;
    const bool begun = gap_ && gap_->of == bench_.session.shared_scene();
    const std::uint32_t wall = hovered_ && pick_.handle == Handle::none ? pick_.primitive : none;
    if (wall != none) {
        const Primitive<2>& s = bench_.session.scene().primitives[wall];
        const ImVec2 mouse = ImGui::GetIO().MousePos,
                     at = pane.camera.to_window(nearest_on(s, pane.camera.to_scene(mouse)));
        // A wall may be several segments in a row: this is the one.
        for (const Vec<2>& end : s) list.AddCircleFilled(pane.camera.to_window(end), 4 * unit, colour(theme::ink));
        list.AddLine(pane.camera.to_window(s[0]), pane.camera.to_window(s[1]), colour(theme::ink), 3 * unit);
        if (begun && gap_->segment == wall) {
            list.AddLine(pane.camera.to_window(gap_->at), at, IM_COL32_WHITE, 8 * unit);
            list.AddLine(pane.camera.to_window(gap_->at), at, colour(theme::accent), 2 * unit);
        }
        list.AddCircle(at, 6 * unit, colour(theme::accent), 0, 2 * unit);
    }
    if (begun) list.AddCircleFilled(pane.camera.to_window(gap_->at), 5 * unit, colour(theme::accent));
}

void Mouse2d::tooltip(Ui& ui) {
    if (!hovered_ || !ui.mouse_awake || drag_ || !pane_ || field_.is_open()) return;
    std::string text = handle_tip(pick_.handle);
    if (text.empty() && strip_) text = strip_words(pane_->session->scene(), *pane_->strip, *strip_);
    if (text.empty() && pick_.node != none) text = conceal(bench_, box_sentence(*pane_->session, pick_.node));
    if (text.empty() && pick_.cell != none && !asks_for_cell(bench_))
        text = conceal(bench_, cell_words(*pane_->session, pick_.cell));
    if (const Scene<2>& scene = pane_->session->scene(); pick_.primitive != none && !scene.objects.empty())
        text = primitive_name(scene, pick_.primitive) + (text.empty() ? "" : "\n" + text);
    if (text.empty()) return;
    // Beside the pointer, not on the cell that it speaks of.
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Area& area = pane_->camera.area;
    const float w = ImGui::CalcTextSize(text.c_str()).x + 20 * ui.unit, off = 18 * ui.unit;
    const float x = mouse.x + off + w < area.x + area.w ? mouse.x + off : std::max(area.x, mouse.x - off - w);
    ImGui::SetNextWindowPos({x, mouse.y + off});
    ImGui::SetTooltip("%s", text.c_str());
}

void Mouse2d::draw(Ui& ui, std::span<const MousePane> panes, const Area& area) {
    for (const MousePane& pane : panes) {
        draw_strip(ui, pane);
        draw_handles(ui, pane);
        draw_gap(ui, pane);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (drag_) {
        if (const auto end = snap_point(bench_, *drag_, mouse, ui.unit))
            list.AddCircle(drag_->camera.to_window(*end), 7 * ui.unit, colour(theme::accent), 0, 2 * ui.unit);
    } else if (hovered_ && pane_ && pane_->lead && bench_.desk.tool == Tool::segment) {
        const Vec<2> at = pane_->camera.to_scene(mouse);
        const Vec<2> end = snapped_to_end(bench_.session, pane_->camera, at, ui.unit);
        if (end != at) list.AddCircle(pane_->camera.to_window(end), 7 * ui.unit, colour(theme::accent), 0, 2 * ui.unit);
    }
    tooltip(ui);
    field_.draw(ui, area);
    ui.awaits_text = field_.is_open();
}

}  // namespace sightline
