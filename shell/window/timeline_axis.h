// The horizontal axis of the timeline: from steps to places and back, whatever the axis counts. Pure functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sightline {

/// The part of the axis that is shown, and where. Step s covers the values (ends[s - 1], ends[s]]: its own number, or
/// the primitives rendered so far. Steps that render nothing then have no width.
struct StepAxis {
    /// Not falling, from ends[0] = 0 for the start; one more than there are steps.
    std::span<const std::uint32_t> ends;
    double from = 0, to = 1;  ///< values at the left and the right edge; from < to
    float x = 0, w = 1;       ///< of the left edge, and from there to the right edge
};

/// A part of a run, as shares of its steps: 0 <= from < to <= 1.
struct Shares {
    double from = 0, to = 1;
};

/// Values that are always shown, where the run has as many.
inline constexpr double least_shown = 5;

/// Clamps `shown` to what can be shown.
StepAxis make_axis(std::span<const std::uint32_t> ends, const Shares& shown, float x, float w);

float x_of_value(const StepAxis& axis, double value);
double value_at(const StepAxis& axis, float x);
/// Where the position stands after a step: at its end.
float x_of_step(const StepAxis& axis, std::uint32_t step);
/// The middle of a step, for its marks; of the start for step 0.
float middle_of_step(const StepAxis& axis, std::uint32_t step);
/// The step that covers this place; 0 left of the first one, the last one right of it.
std::uint32_t step_at(const StepAxis& axis, float x);
/// The step whose end is nearest.
std::uint32_t nearest_step(const StepAxis& axis, float x);

/// Steps of 1 or more that cover a part of (from, to], and those without width in [from, to]. Empty: first > last.
struct StepRange {
    std::uint32_t first = 1, last = 0;
};
StepRange steps_between(const StepAxis& axis, double from, double to);

/// `factor` times as large around x, whose value stays there unless an end of the run comes into view.
Shares zoomed(const StepAxis& axis, float x, double factor);
/// Moved by dx to the right, as far as the run goes.
Shares panned(const StepAxis& axis, float dx);
/// Moved so that the step is in the middle.
Shares centred(const StepAxis& axis, std::uint32_t step);

/// Values at 1, 2 or 5 times a power of ten, at least `gap` apart on the screen.
std::vector<double> nice_values(const StepAxis& axis, float gap);

}  // namespace sightline
