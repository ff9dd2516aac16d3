// Times of one frame. Nothing else may run meanwhile: whoever calls these stops other threads first.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/stopwatch.h"
#include "core/traversal/methods.h"

namespace sightline::lab {

inline double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// Milliseconds.
struct DrawTimes {
    double upload = 0, draw = 0;
};

/// Draws triangles of the scene as `view` sees them, `repeats` times after once to warm up; medians. 3D only.
using TimeDrawing = std::function<DrawTimes(const std::shared_ptr<const Scene<3>>& scene, const View<3>& view,
                                            std::span<const std::uint32_t> triangles, std::uint32_t repeats)>;

/// Median of starting and running the method to the frame's budget, unrecorded, after one run to warm up. `state` is
/// reused from frame to frame, as a flight does; it ends as that run leaves it.
template <int D>
double time_traversal(const Method<D>& method, const Frame<D>& frame, State<D>& state, std::uint32_t repeats) {
    std::vector<double> times;
    for (std::uint32_t i = 0; i <= repeats; ++i) {
        const Stopwatch stopwatch;
        method.start(frame, state);
        method.run(frame, state, none);
        if (i > 0) times.push_back(stopwatch.milliseconds());
    }
    return median(std::move(times));
}

}  // namespace sightline::lab
