// Times of one frame. Nothing else may run meanwhile: whoever calls these stops other threads first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/measure/summary.h"
#include "core/run/method.h"
#include "core/scene/scene.h"

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

/// Whether a frame has to pay for the traversal: a method that is told what is visible stands for drawing it alone.
template <int D>
bool pays_for_traversal(const Method<D>& method) {
    return !method.needs.visible_set;
}

/// Sets the times of a frame: medians, their sum, and the standard errors of the samples' means. What has no sample is
/// no part of the sum; without any there is none.
void set_times(const TimeSamples& samples, Values& values);

/// Milliseconds of starting and running the method to the problem's budget, unrecorded. `run` is reused from frame to
/// frame, as a flight does; it must be empty or one of this method.
template <int D>
double run_milliseconds(const Method<D>& method, const Problem<D>& problem, OwnRun<D>& run) {
    const Stopwatch stopwatch;
    run.start(problem, method.start);
    run->run(none);
    return stopwatch.milliseconds();
}

}  // namespace sightline
