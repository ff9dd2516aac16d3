// Whether budgets in time hold: frames along a path, one after the other, each drawn for what it rendered.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lab/measure/measure_path.h"

namespace sightline::lab {

/// For every method with a budget and every budget in milliseconds, on a scene that can be drawn; empty without
/// instruments.time_drawing, or where Instruments::frame_done would have stopped: `go_on` false ends it early. The path
/// is flown once to warm up, with all that it teaches forgotten, then once for each of the study's repeats.
std::vector<TimedFlight> fly_in_time(const LabScene<3>& lab, const Study& study, const Instruments& instruments,
                                     const std::function<bool()>& go_on);

/// Of flown frames those that took no more than the budget and a tenth of it; NaN of nothing.
double share_kept(const TimedFlight& flight);
/// The longest frame; NaN of nothing.
double longest_ms(const TimedFlight& flight);

}  // namespace sightline::lab
