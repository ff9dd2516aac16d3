// What a lane draws: a value per step, thinned to as many columns as the screen can show. Pure functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "shell/window/timeline_axis.h"

namespace sightline {

/// The smallest and the largest value of the steps that are drawn in [x0, x1].
struct LaneSpan {
    float x0 = 0, x1 = 0;
    double low = 0, high = 0;
};

/// values[s - 1] belongs to step s; those that are not finite are left out. A span per step that is shown, also where
/// it has no width, or at most `columns` where there are more.
std::vector<LaneSpan> lane_spans(const StepAxis& axis, std::span<const double> values, std::uint32_t columns);

}  // namespace sightline
