// The frames in which methods are measured beside one another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/measure/trade_off.h"
#include "core/scene/flight_path.h"
#include "core/scene/scene_view.h"

namespace sightline {

/// A frame and the one before it, as an eye that goes along the path or stands still meets them.
template <int D>
struct FrameToMeasure {
    ViewSpec<D> view, before;
};

/// `wanted` frames of the path, spread evenly over it; of an empty one the view alone.
template <int D>
std::vector<FrameToMeasure<D>> frames_to_measure(const std::vector<ViewSpec<D>>& path, const ViewSpec<D>& view,
                                                 std::size_t wanted) {
    if (path.empty()) return {{view, view}};
    std::vector<FrameToMeasure<D>> frames;
    for (const std::size_t frame : spread_frames(path.size(), wanted))
        frames.push_back({path[frame], path[frame == 0 ? 0 : frame - 1]});
    return frames;
}

/// As views of the task's scene, at the size of its reference.
template <int D>
void add_frames(TradeOffTask<D>& task, const std::vector<FrameToMeasure<D>>& frames) {
    for (const FrameToMeasure<D>& frame : frames) {
        task.views.push_back(scene_view(frame.view, *task.scene, task.reference_size));
        task.before.push_back(scene_view(frame.before, *task.scene, task.reference_size));
    }
}

}  // namespace sightline
