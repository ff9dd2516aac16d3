// The lanes of the recorded run: what the mouse does with them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "shell/desk/moves.h"
#include "shell/desk/play.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"
#include "shell/window/timeline_frames.h"
#include "shell/window/timeline_lanes.h"

namespace sightline {

namespace {

using Drag = TimelineData::Drag;

template <int D>
void go_to(Ui& ui, Workbench<D>& bench, std::uint32_t step) {
    if (step == bench.session.position() && !bench.substep) return;
    pause(bench);
    go_to_step(bench, step);
    ++ui.revision;
}

template <int D>
void show(Workbench<D>& bench, const Shares& shares) {
    bench.desk.timeline_from = shares.from;
    bench.desk.timeline_to = shares.to;
}

std::string step_tip(const TimelineData& data, std::uint32_t step) {
    std::string tip = "step " + std::to_string(step);
    if (step == 0) return tip + ": the start";
    const auto value = [&](Curve curve) { return data.values[static_cast<std::size_t>(curve)][step - 1]; };
    tip += ":";
    if (data.cell[step - 1] != none) tip += " cell " + std::to_string(data.cell[step - 1]) + ",";
    if (std::isfinite(value(Curve::key))) tip += " key " + short_number(value(Curve::key)) + ",";
    tip += " " + short_number(value(Curve::visible)) + " visible + " + short_number(value(Curve::hidden)) + " hidden";
    if (data.cell[step - 1] != none) tip += ", front " + short_number(value(Curve::front));
    if (std::isfinite(value(Curve::coverage))) tip += ", coverage " + short_number(value(Curve::coverage));
    return tip;
}

template <int D>
std::string mark_tip(const TimelineData& data, const Workbench<D>& bench, const MarkGroup& group) {
    const TimelineMark& mark = data.marks[group.first];
    std::string tip = "step " + std::to_string(mark.step) + ": " + std::string(look(mark.kind).word);
    if (mark.kind == MarkKind::matched) tip += " of " + bench.marked_by;
    if (!mark.label.empty()) tip += (mark.kind == MarkKind::bookmark ? " " : ", ") + mark.label;
    if (group.count > 1) tip += ", and " + std::to_string(group.count - 1) + " more here";
    return tip;
}

/// The marks under the mouse, if any: of its row, and within reach.
const MarkGroup* group_at(const TimelineData& data, const TimelineLayout& layout, const ImVec2& mouse, float unit) {
    if (!layout.marks.contains(mouse)) return nullptr;
    const int row = static_cast<int>((mouse.y - layout.marks.y - unit) / layout.mark_row);
    const MarkGroup* found = nullptr;
    float nearest = 6 * unit;
    for (const MarkGroup& group : data.groups) {
        const float distance = std::abs(group.x - mouse.x);
        if (look(group.kind).row != row || distance > nearest) continue;
        nearest = distance;
        found = &group;
    }
    return found;
}

/// The handle catches the mouse wherever it covers the ruler.
bool on_handle(const TimelineData& data, const TimelineLayout& layout, const ImVec2& mouse, float unit) {
    return layout.ruler.contains(mouse) && std::abs(x_of_step(data.axis, data.position) - mouse.x) < 10 * unit;
}

template <int D>
void drag(Ui& ui, Workbench<D>& bench, const TimelineLayout& layout) {
    TimelineData& data = ui.timeline;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 mouse = io.MousePos;
    if (ImGui::IsItemActivated()) {
        const MarkGroup* const marks = group_at(data, layout, mouse, ui.unit);
        data.drag = !io.MouseDown[ImGuiMouseButton_Left]      ? Drag::pan
                    : on_handle(data, layout, mouse, ui.unit) ? Drag::handle
                    : marks                                   ? Drag::none
                                                              : Drag::seek;
        if (marks && data.drag == Drag::none) go_to(ui, bench, data.marks[marks->first].step);
    }
    if (!ImGui::IsItemActive()) data.drag = Drag::none;
    if (data.drag == Drag::pan && io.MouseDelta.x != 0) show(bench, panned(data.axis, io.MouseDelta.x));
    if (data.drag == Drag::seek || data.drag == Drag::handle) {
        const float x = std::clamp(mouse.x, data.axis.x, data.axis.x + data.axis.w);
        go_to(ui, bench, data.drag == Drag::seek ? step_at(data.axis, x) : nearest_step(data.axis, x));
    }
}

/// What the mouse does over the plot, which is the last item.
template <int D>
void mouse(Ui& ui, Workbench<D>& bench, const TimelineLayout& layout) {
    TimelineData& data = ui.timeline;
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    drag(ui, bench, layout);
    if (hovered && io.MouseWheel != 0) show(bench, zoomed(data.axis, io.MousePos.x, std::pow(1.25, io.MouseWheel)));
    if (hovered && layout.ruler.contains(io.MousePos) && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        ui.act("zoom-timeline all");
    if (!hovered || data.drag == Drag::pan) return;
    const MarkGroup* const marks = group_at(data, layout, io.MousePos, ui.unit);
    const std::uint32_t step = marks ? data.marks[marks->first].step : step_at(data.axis, io.MousePos.x);
    if (step > 0) ui.hovering = data.cell[step - 1];
    draw_hovered_step(*ImGui::GetWindowDrawList(), ui, layout, data, step);
    const std::string tip = marks ? mark_tip(data, bench, *marks) : step_tip(data, step);
    ImGui::SetTooltip("%s", tip.c_str());
}

/// A row per kind, with its shape.
void key_tip(const Ui& ui) {
    ImGui::BeginTooltip();
    const float side = ImGui::GetFontSize() * 0.7f;
    for (const MarkLook& how : mark_looks) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        draw_mark(*ImGui::GetWindowDrawList(), how.shape, {at.x + side / 2, at.y + ImGui::GetFontSize() / 2}, side,
                  colour(how.colour));
        ImGui::Dummy({side + 4 * ui.unit, ImGui::GetFontSize()});
        ImGui::SameLine();
        ImGui::Text("%s: %s", std::string(how.word).c_str(), std::string(how.text).c_str());
    }
    ImGui::TextDisabled(
        "Where shapes do not fit, marks are strokes; a darker stroke is several marks. Click to go to the step.");
    ImGui::EndTooltip();
}

template <int D>
void header(Ui& ui, Workbench<D>& bench, const TimelineLayout& layout) {
    const bool steps = bench.desk.axis == TimelineAxis::steps;
    ImGui::SetCursorScreenPos(layout.header.min());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4 * ui.unit, 0});
    if (ImGui::Button(steps ? "by steps" : "by primitives")) ui.act(steps ? "axis primitives" : "axis steps");
    ImGui::PopStyleVar();
    note_place(bench, "timeline axis");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", steps ? "count rendered primitives instead" : "count steps instead");
    const auto tip = [&](const Area& lane, const char* id, const char* text) {
        if (lane.h == 0) return;
        ImGui::SetCursorScreenPos({layout.header.x, lane.y});
        ImGui::InvisibleButton(id, {std::max(1.0f, layout.header.w), lane.h});
        if (!ImGui::IsItemHovered()) return;
        if (text)
            ImGui::SetTooltip("%s", text);
        else
            key_tip(ui);
    };
    tip(layout.marks, "marks", nullptr);
    tip(layout.lanes[TimelineLayout::rendered], "rendered",
        "primitives that the step rendered: visible ones up, hidden ones down");
    tip(layout.lanes[TimelineLayout::key], "key", "the key of the cell that the step projected");
    tip(layout.lanes[TimelineLayout::front], "front", "cells in the front after the step");
    tip(layout.lanes[TimelineLayout::coverage], "coverage",
        "share of the visible primitives rendered so far, and the best possible with as many (oracle)");
}

/// Places for scripts: the lanes, the handle, and the first mark of each kind.
template <int D>
void note_places(Workbench<D>& bench, const TimelineLayout& layout, const TimelineData& data, float unit) {
    const Area& ruler = layout.ruler;
    const float top = layout.lanes.front().y, x = x_of_step(data.axis, data.position);
    bench.places.push_back({"timeline", ruler.x, top, ruler.w, layout.bottom() - top});
    bench.places.push_back({"timeline ruler", ruler.x, ruler.y, ruler.w, ruler.h});
    if (x >= ruler.x - 1 && x <= ruler.x + ruler.w + 1)
        bench.places.push_back({"timeline handle", x - 8 * unit, ruler.y, 16 * unit, ruler.h});
    const MarkGroup* before = nullptr;
    for (const MarkGroup& group : data.groups) {
        if (!before || before->kind != group.kind)
            bench.places.push_back({"mark " + std::string(look(group.kind).word), group.x - 4 * unit,
                                    layout.marks.y + unit + static_cast<float>(look(group.kind).row) * layout.mark_row,
                                    8 * unit, layout.mark_row});
        before = &group;
    }
}

/// Over the run that was recorded last, while frames fly by that are not.
void draw_veil(ImDrawList& list, const Ui& ui, const TimelineLayout& layout) {
    constexpr const char* text = "the run before the flight; a new one is recorded on landing";
    const Area& ruler = layout.ruler;
    list.AddRectFilled(ruler.min(), {ruler.x + ruler.w, layout.bottom()}, IM_COL32(243, 244, 245, 170));
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 at{ruler.x + std::max(0.0f, (ruler.w - size.x) / 2), (ruler.y + layout.bottom() - size.y) / 2};
    list.AddRectFilled({at.x - 8 * ui.unit, at.y - 4 * ui.unit},
                       {at.x + size.x + 8 * ui.unit, at.y + size.y + 4 * ui.unit}, colour(theme::paper));
    list.AddText(at, colour(theme::ink), text);
}

/// A step that is made outside the shown part brings it into view.
template <int D>
void follow_run(TimelineData& data, Workbench<D>& bench) {
    const std::uint32_t position = bench.session.position();
    if (position == data.position) return;
    data.position = position;
    const double value = data.axis.ends[position];
    if (data.drag == Drag::none && (value < data.axis.from || value > data.axis.to))
        show(bench, centred(data.axis, position));
}

}  // namespace

template <int D>
void timeline(Ui& ui, Workbench<D>& bench, const Area& area) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    begin_part("timeline", area, ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    TimelineData& data = ui.timeline;
    const float unit = ui.unit, side = 10 * unit;
    const float frames = frames_height(ui, bench);
    const TimelineLayout layout =
        timeline_layout(ui, {area.x + side, area.y + 3 * unit, std::max(area.w - 2 * side, 1.0f),
                             std::max(area.h - 8 * unit - frames, 1.0f)});
    if (!update(data, bench, layout.ruler.x, layout.ruler.w, unit)) {
        ImGui::SetCursorScreenPos({area.x + side, area.y + area.h / 2 - ImGui::GetFontSize() / 2});
        ImGui::TextDisabled("The run has no steps: there is nothing to project from here.");
        ImGui::End();
        return;
    }
    follow_run(data, bench);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Colours& palette = colours(bench.session.settings().palette);
    draw_lanes(list, ui, layout, data, palette);
    draw_marks(list, ui, layout, data);
    draw_ruler(list, ui, layout, data);
    header(ui, bench, layout);
    ImGui::SetCursorScreenPos(layout.ruler.min());
    ImGui::InvisibleButton(
        "plot", {std::max(1.0f, layout.ruler.w), std::max(1.0f, layout.bottom() - layout.ruler.y)},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    mouse(ui, bench, layout);
    data.position = bench.session.position();
    draw_position(list, ui, layout, data, palette);
    draw_step_of_cell(list, ui, layout, data, bench.hovered_cell);
    if (bench.session.flying()) draw_veil(list, ui, layout);
    note_places(bench, layout, data, unit);
    if (frames > 0)
        frames_row(ui, bench, layout, {area.x + side, area.y + area.h - 4 * unit - frames, area.w - 2 * side, frames});
    ImGui::End();
}

template void timeline<2>(Ui&, Workbench<2>&, const Area&);
template void timeline<3>(Ui&, Workbench<3>&, const Area&);

}  // namespace sightline
