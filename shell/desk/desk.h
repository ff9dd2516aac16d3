// How the window is set up: plain data, so that keys, menus, scripts and the memory of the last time share it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace sightline {

/// What a press of the mouse on the picture does.
enum class Tool : std::uint8_t { select, segment, gap, text, arrow, ring, callout };
inline constexpr auto tool_words =
    std::to_array<std::string_view>({"select", "segment", "gap", "text", "arrow", "ring", "callout"});

/// Tools that change the scene: of the edit mode alone.
constexpr bool edits_scene(Tool tool) { return tool == Tool::segment || tool == Tool::gap; }

/// What the timeline's horizontal axis counts.
enum class TimelineAxis : std::uint8_t { steps, primitives };
inline constexpr auto timeline_axis_words = std::to_array<std::string_view>({"steps", "primitives"});

/// Limits of Desk::scale.
inline constexpr double smallest_scale = 0.5, largest_scale = 4;

struct Desk {
    bool projector = false;  ///< panels hidden, the formula as a banner, large text
    double scale = 1;        ///< of everything, on top of what the screen asks for
    bool fullscreen = false;
    std::string projector_panel;  ///< the one that stays in projector mode; empty: none
    bool animate = true;          ///< what a step changes fades in
    bool blank = false;           ///< nothing but a dark window: the class looks at the lecturer
    bool speaker = false;         ///< notes and clock in a window of their own
    bool edit = false;            ///< 2D: walls and the view have handles; otherwise a drag moves the eye or pans
    bool chooser = false;         ///< the scenes, over the picture
    std::string chooser_text;     ///< what its list is filtered by
    bool lessons = false;         ///< the lessons, over the picture
    bool help = false;            ///< all keys, over the picture
    bool console = false;         ///< a line to type commands into
    std::string console_text;
    Tool tool = Tool::select;

    // Panels by id (shell/panels). A column shows one of its panels; empty: the column is hidden.
    std::string left, right = "why";
    bool timeline = false, legend = true;
    double left_width = 320, right_width = 380, timeline_height = 215;  ///< pixels at scale 1

    TimelineAxis axis = TimelineAxis::steps;
    double timeline_from = 0, timeline_to = 1;  ///< the part shown, as shares of the whole run
    bool operator==(const Desk&) const = default;
};

}  // namespace sightline
