// Times of one frame. Nothing else may run meanwhile: whoever calls these stops other threads first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/measure/summary.h"
#include "core/scene/scene.h"
#include "core/traversal/methods.h"

namespace sightline {

/// Milliseconds.
struct DrawTimes {
    double upload = 0, draw = 0;
};

/// Draws triangles of the scene as `view` sees them, once. 3D only.
using TimeDrawing = std::function<DrawTimes(const std::shared_ptr<const Scene<3>>& scene, const View<3>& view,
                                            std::span<const std::uint32_t> triangles)>;

/// What was timed of one frame, milliseconds each; a value per repeat.
struct TimeSamples {
    std::vector<double> traverse, upload, draw;  ///< upload and draw are empty in 2D
};

/// Sets the times of a frame: medians, their sum, and the standard errors of the samples' means.
void set_times(const TimeSamples& samples, Values& values);

/// Milliseconds of starting and running the method to the frame's budget, unrecorded. `state` is reused from frame to
/// frame, as a flight does; it ends as the run leaves it.
template <int D>
double run_milliseconds(const Method<D>& method, const Frame<D>& frame, State<D>& state) {
    const Stopwatch stopwatch;
    method.start(frame, state);
    method.run(frame, state, none);
    return stopwatch.milliseconds();
}

/// The primitives that a state's run has rendered, in their order.
template <int D>
void rendered_ids(const State<D>& state, std::vector<std::uint32_t>& ids) {
    ids.clear();
    for (std::uint32_t i = 0; i < state.touched_count; ++i)
        if (!(state.touched[i] & State<D>::culled_bit)) ids.push_back(state.touched[i]);
}

}  // namespace sightline
