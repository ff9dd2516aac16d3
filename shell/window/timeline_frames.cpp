// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_frames.h"

#include <algorithm>

#include "core/base/text.h"
#include "shell/desk/frames.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// More than this many are not run to be counted, nor told apart on the screen.
constexpr std::size_t most_frames = 64;

std::string frame_tip(const TimelineData& data, std::size_t frame, std::size_t slot, bool here) {
    std::string tip = "frame " + std::to_string(frame);
    if (data.frame_changes[slot])
        tip += ": " + counted(*data.frame_changes[slot], "box") + " changed state";
    else
        tip += ": the first one here";
    return tip + (here ? ", shown" : ". Click to step into it");
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
    const float unit = ui.unit, text = ImGui::GetFontSize() * 0.87f;
    small_text(list, ui, layout.header.x, area.y + (area.h - text) / 2, "frames: boxes changed", theme::ink);
    std::uint32_t most = 1;
    for (const auto& changed : data.frame_changes) most = std::max(most, changed.value_or(0));
    const float x = layout.ruler.x, slot = layout.ruler.w / static_cast<float>(shown), base = area.y + area.h - unit;
    for (std::size_t i = 0; i < shown; ++i) {
        const float left = x + slot * static_cast<float>(i), right = left + std::min(slot - unit, 60 * unit);
        const bool here = first + i == count.here;
        const auto changed = data.frame_changes[i];
        const float h = changed ? (area.h - 2 * unit) * static_cast<float>(*changed) / static_cast<float>(most) : 0;
        list.AddRectFilled({left, base - std::max(h, 2 * unit)}, {right, base},
                           colour(here ? theme::accent : theme::faint));
        if (changed && slot > small_width(ui, std::to_string(*changed)) + 6 * unit)
            small_text(list, ui, right + 4 * unit < left + slot ? right + 3 * unit : left + 3 * unit,
                       area.y + (area.h - text) / 2, std::to_string(*changed), theme::ink);
        bench.places.push_back({"frame " + std::to_string(first + i), left, area.y, slot, area.h});
    }
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
