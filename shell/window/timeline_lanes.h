// The drawing of the timeline: ruler, marks and lanes as they are, without the mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/palette.h"
#include "shell/window/timeline_data.h"
#include "shell/window/ui.h"

namespace sightline {

/// Where everything stands, in the window's units.
struct TimelineLayout {
    Area header;  ///< titles and scales, left of the plot
    Area ruler, budgets, marks;
    enum Lane : std::uint8_t { rendered, key, front, coverage, lane_count };
    std::array<Area, lane_count> lanes;  ///< h = 0: left out, there is no room for it
    float text = 0;                      ///< height of the small text
    float mark_row = 0;
    float bottom() const { return lanes.back().y + lanes.back().h; }
};

/// The ruler, the marks' lane and the lanes share `area`; the plot takes what the header leaves.
TimelineLayout timeline_layout(const Ui& ui, const Area& area);

void draw_lanes(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data,
                const Colours& colours);
void draw_ruler(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data);
void draw_marks(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data);
/// The line and its handle; dims what is still to come.
void draw_position(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data,
                   const Colours& colours);
/// A band over the step under the mouse.
void draw_hovered_step(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data,
                       std::uint32_t step);
/// A triangle under the step that projects the hovered cell.
void draw_step_of_cell(ImDrawList& list, const Ui& ui, const TimelineLayout& layout, const TimelineData& data,
                       std::uint32_t cell);

/// A mark of this kind in a square of this side around a point.
void draw_mark(ImDrawList& list, MarkShape shape, const ImVec2& centre, float side, ImU32 c);

/// In the timeline's small text. `align` is the share of the text that lies left of x.
void small_text(ImDrawList& list, const Ui& ui, float x, float y, const std::string& text, const Colour& c,
                float align = 0);
float small_width(const Ui& ui, const std::string& text);

}  // namespace sightline
