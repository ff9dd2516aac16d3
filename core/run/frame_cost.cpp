// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/frame_cost.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sightline {

namespace {

double middle(std::vector<double>& values) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

double traversal_ms_left(double budget_ms, double elapsed_ms, const FrameCost& cost, std::uint32_t rendered) {
    return std::max(0.0, budget_ms - elapsed_ms - cost.ms(rendered));
}

void note_frame(DrawnFrames& frames, std::uint32_t rendered, double ms) {
    if (!std::isfinite(ms) || ms < 0) return;
    frames.last[frames.count++ % frames.last.size()] = {rendered, ms};
}

FrameCost predict_cost(const DrawnFrames& frames, double budget_ms) {
    const std::size_t n = std::min(frames.count, frames.last.size());
    if (n == 0) return {0.001, budget_ms / 4};
    // Where two frames rendered nearly the same number, noise alone would tell the slope.
    std::vector<double> slopes, counts, times;
    for (std::size_t i = 0; i < n; ++i) {
        const DrawnFrames::Frame& a = frames.last[i];
        counts.push_back(a.rendered);
        times.push_back(a.ms);
        for (std::size_t j = 0; j < i; ++j) {
            const DrawnFrames::Frame& b = frames.last[j];
            const double apart = static_cast<double>(a.rendered) - static_cast<double>(b.rendered);
            if (std::abs(apart) * 10 > std::max(a.rendered, b.rendered)) slopes.push_back((a.ms - b.ms) / apart);
        }
    }
    FrameCost cost;
    // Without a slope half of the time counts as that of the primitives.
    const double count = middle(counts), time = middle(times);
    if (slopes.size() >= 3)
        cost.per_primitive_ms = std::max(0.0, middle(slopes));
    else if (count > 0)
        cost.per_primitive_ms = time / (2 * count);
    double most = 0, next = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double rest = frames.last[i].ms - cost.per_primitive_ms * frames.last[i].rendered;
        next = std::max(next, std::min(rest, most));
        most = std::max(most, rest);
    }
    cost.fixed_ms = n > 1 && most - next > budget_ms / 4 ? next : most;
    return cost;
}

}  // namespace sightline
