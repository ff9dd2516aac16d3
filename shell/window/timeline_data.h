// What the timeline keeps between frames: made again when the run, or the part that is shown, has changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shell/desk/frames.h"
#include "shell/window/timeline_marks.h"
#include "shell/window/timeline_ruler.h"
#include "shell/window/timeline_spans.h"

namespace sightline {

/// Values per step; values[s - 1] belongs to step s.
enum class Curve : std::uint8_t { visible, hidden, key, front, coverage, oracle, count };

struct TimelineData {
    // Of the run.
    std::uint64_t run = 0;  ///< that all this was made for; 0: none yet
    std::array<std::vector<double>, static_cast<std::size_t>(Curve::count)> values;
    std::array<double, static_cast<std::size_t>(Curve::count)> lowest{},
        highest{};                                       ///< over the whole run; 0 is between
    std::vector<std::uint32_t> cell;                     ///< that each step projects; none for orders of primitives
    std::vector<std::uint32_t> step_of_cell;             ///< 0 where no step does
    std::vector<std::uint32_t> by_steps, by_primitives;  ///< StepAxis::ends
    std::vector<double> other_coverage;                  ///< per step of the run beside it; empty without one
    std::vector<Marker> found;
    std::vector<BudgetTick> budgets;

    // Of what people put there.
    std::vector<Bookmark> bookmarks;
    std::vector<Breakpoint> breakpoints;
    std::vector<std::uint32_t> matched;
    std::uint32_t difference = none;
    std::vector<TimelineMark> marks;

    // Of the part that is shown.
    TimelineAxis counts = TimelineAxis::steps;
    StepAxis axis;
    float unit = 0;
    std::array<std::vector<LaneSpan>, static_cast<std::size_t>(Curve::count)> spans;
    std::vector<MarkGroup> groups;

    // Of the lane of frames (timeline_frames.h).
    std::uint64_t frames_of = 0;  ///< run that they were counted for
    std::vector<FrameChange> frame_changes;

    // Of the mouse and the last frame.
    enum class Drag : std::uint8_t { none, seek, handle, pan } drag = Drag::none;
    std::uint32_t position = 0;
};

/// Most spans per curve: the screen shows no more, and a frame stays cheap.
inline constexpr std::uint32_t most_columns = 800;

/// What belongs to the run alone, if it is out of date. False when there are no steps.
template <int D>
bool update_run(TimelineData& data, const Workbench<D>& bench);

/// Whatever is out of date. False when there is nothing to draw: no steps.
template <int D>
bool update(TimelineData& data, const Workbench<D>& bench, float x, float w, float unit);

}  // namespace sightline
