// Under the timeline, a row of the frames that were flown, of a method that knows the frame before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/window/timeline_lanes.h"

namespace sightline {

/// Of the row; 0: there are no frames.
template <int D>
float frames_height(const Ui& ui, const Workbench<D>& bench);

/// `area` is as wide as the timeline, whose plot it stands under. A click steps into a frame.
template <int D>
void frames_row(Ui& ui, Workbench<D>& bench, const TimelineLayout& layout, const Area& area);

}  // namespace sightline
