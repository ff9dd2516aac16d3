// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_frames.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/draw/variant_look.h"
#include "shell/desk/frames.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// More than this many are not run to be counted, nor told apart on the screen.
constexpr std::size_t most_frames = 64;

/// Of a frame whose technique differs from that of the one before it.
bool is_switch(const TimelineData& data, std::size_t slot) {
    return slot > 0 && data.frame_changes[slot].technique != data.frame_changes[slot - 1].technique;
}

std::string frame_tip(const TimelineData& data, std::size_t frame, std::size_t slot, bool here) {
    const FrameChange& change = data.frame_changes[slot];
    std::string tip = "frame " + std::to_string(frame);
    if (!change.technique.empty())
        tip += ": " + change.technique +
               (is_switch(data, slot) ? ", after " + data.frame_changes[slot - 1].technique : "");
    else if (change.boxes)
        tip += ": " + counted(*change.boxes, "box") + " changed state";
    else
        tip += ": the first one here";
    return tip + (here ? ", shown" : ". Click to step into it");
}

/// A bar as high as the boxes are many that the frame changed, with their number.
void changes_bar(ImDrawList& list, const Ui& ui, const Area& slot, std::optional<std::uint32_t> changed,
                 std::uint32_t most, bool here) {
    const float unit = ui.unit, text = ImGui::GetFontSize() * 0.87f, base = slot.y + slot.h - unit;
    const float right = slot.x + std::min(slot.w - unit, 60 * unit);
    const float h = changed ? (slot.h - 2 * unit) * static_cast<float>(*changed) / static_cast<float>(most) : 0;
    list.AddRectFilled({slot.x, base - std::max(h, 2 * unit)}, {right, base},
                       colour(here ? theme::accent : theme::faint));
    if (changed && slot.w > small_width(ui, std::to_string(*changed)) + 6 * unit)
        small_text(list, ui, right + 4 * unit < slot.x + slot.w ? right + 3 * unit : slot.x + 3 * unit,
                   slot.y + (slot.h - text) / 2, std::to_string(*changed), theme::ink);
}

/// The frames by technique: a band in the colours of charts, with a name where another one begins and has room, a line
/// there, and the frame that is shown in a rim.
void techniques_band(ImDrawList& list, const Ui& ui, const TimelineData& data, const Area& area, float slot,
                     std::optional<std::size_t> here) {
    const float unit = ui.unit, text = ImGui::GetFontSize() * 0.87f, top = area.y + unit, base = area.y + area.h - unit;
    std::vector<std::string> names;
    for (const FrameChange& change : data.frame_changes) names.push_back(change.technique);
    const std::vector<VariantLook> looks = variant_looks(names);
    const auto x = [&](std::size_t i) { return area.x + slot * static_cast<float>(i); };
    for (std::size_t i = 0, end = 0; i < names.size(); i = end) {
        for (end = i; end < names.size() && names[end] == names[i];) ++end;
        list.AddRectFilled({x(i), top}, {x(end), base}, colour(looks[i].colour));
        if (i > 0) list.AddLine({x(i), area.y}, {x(i), area.y + area.h}, colour(theme::ink), 2 * unit);
        if (x(end) - x(i) > small_width(ui, names[i]) + 8 * unit)
            small_text(list, ui, x(i) + 4 * unit, area.y + (area.h - text) / 2, names[i], {255, 255, 255});
    }
    if (here) list.AddRect({x(*here), area.y}, {x(*here + 1), area.y + area.h}, colour(theme::ink), 0, 0, 2 * unit);
}

}  // namespace

template <int D>
float frames_height(const Ui& ui, const Workbench<D>& bench) {
    return count_frames(bench).frames > 0 && !bench.session.flying() ? ImGui::GetFontSize() * 0.87f + 8 * ui.unit : 0;
}

template <int D>
void frames_row(Ui& ui, Workbench<D>& bench, const TimelineLayout& layout, const Area& area) {
    TimelineData& data = ui.timeline;
    const FrameCount count = count_frames(bench);
    if (data.frames_of != bench.run || data.frame_changes.empty()) {
        data.frame_changes = frame_changes(bench, most_frames);
        data.frames_of = bench.run;
    }
    const std::size_t shown = data.frame_changes.size(), first = count.frames - std::min(count.frames, shown);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float text = ImGui::GetFontSize() * 0.87f;
    const bool by_technique = !data.frame_changes.empty() && !data.frame_changes.front().technique.empty();
    small_text(list, ui, layout.header.x, area.y + (area.h - text) / 2,
               by_technique ? "frames: technique" : "frames: boxes changed", theme::ink);
    std::uint32_t most = 1;
    for (const FrameChange& change : data.frame_changes) most = std::max(most, change.boxes.value_or(0));
    const float x = layout.ruler.x, slot = layout.ruler.w / static_cast<float>(shown);
    for (std::size_t i = 0; i < shown; ++i) {
        const Area own{x + slot * static_cast<float>(i), area.y, slot, area.h};
        if (!by_technique) changes_bar(list, ui, own, data.frame_changes[i].boxes, most, first + i == count.here);
        bench.places.push_back({"frame " + std::to_string(first + i), own.x, own.y, own.w, own.h});
    }
    if (by_technique)
        techniques_band(list, ui, data, {x, area.y, layout.ruler.w, area.h}, slot,
                        count.here >= first ? std::optional(count.here - first) : std::nullopt);
    ImGui::SetCursorScreenPos({x, area.y});
    ImGui::InvisibleButton("frames", {std::max(1.0f, layout.ruler.w), area.h});
    if (!ImGui::IsItemHovered()) return;
    const auto under = static_cast<std::size_t>(std::max(0.0f, (ImGui::GetIO().MousePos.x - x) / slot));
    const std::size_t i = std::min(under, shown - 1), frame = first + i;
    ImGui::SetTooltip("%s", frame_tip(data, frame, i, frame == count.here).c_str());
    if (ImGui::IsItemClicked() && frame != count.here) ui.act("frame " + std::to_string(frame));
}

#define SIGHTLINE_INSTANTIATE(D)                                     \
    template float frames_height<D>(const Ui&, const Workbench<D>&); \
    template void frames_row<D>(Ui&, Workbench<D>&, const TimelineLayout&, const Area&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
