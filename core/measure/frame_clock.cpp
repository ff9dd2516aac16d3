// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/frame_clock.h"

#include <cmath>

namespace sightline {

void set_times(const TimeSamples& samples, Values& values) {
    double total = 0, squares = 0;
    const auto set = [&](const std::vector<double>& times, Measure time, Measure error) {
        if (times.empty()) return;
        total += values[time] = median(times);
        squares += std::pow(values[error] = standard_error(times), 2);
    };
    set(samples.traverse, Measure::traverse_ms, Measure::traverse_error);
    set(samples.upload, Measure::upload_ms, Measure::upload_error);
    set(samples.draw, Measure::draw_ms, Measure::draw_error);
    if (samples.traverse.empty() && samples.draw.empty()) return;
    values[Measure::total_ms] = total;
    values[Measure::total_error] = std::sqrt(squares);
}

}  // namespace sightline
