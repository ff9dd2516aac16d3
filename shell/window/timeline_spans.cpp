// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sightline {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<LaneSpan> span_per_step(const StepAxis& axis, std::span<const double> values, const StepRange& shown) {
    std::vector<LaneSpan> spans;
    for (std::uint32_t step = shown.first; step <= shown.last; ++step) {
        const double value = values[step - 1];
        if (!std::isfinite(value)) continue;
        spans.push_back({std::clamp(x_of_step(axis, step - 1), axis.x, axis.x + axis.w),
                         std::clamp(x_of_step(axis, step), axis.x, axis.x + axis.w), value, value});
    }
    return spans;
}

/// Neighbours of the same values become one.
void add(std::vector<LaneSpan>& spans, const LaneSpan& span) {
    if (!spans.empty() && spans.back().x1 == span.x0 && spans.back().low == span.low && spans.back().high == span.high)
        spans.back().x1 = span.x1;
    else
        spans.push_back(span);
}

}  // namespace

std::vector<LaneSpan> lane_spans(const StepAxis& axis, std::span<const double> values, std::uint32_t columns) {
    const StepRange shown = steps_between(axis, axis.from, axis.to);
    if (shown.first > shown.last) return {};
    if (shown.last - shown.first < columns) return span_per_step(axis, values, shown);
    std::vector<LaneSpan> spans;
    const double width = (axis.to - axis.from) / columns;
    for (std::uint32_t column = 0; column < columns; ++column) {
        const double from = axis.from + column * width;
        const double to = column + 1 < columns ? axis.from + (column + 1) * width : axis.to;  // free of rounding
        const StepRange here = steps_between(axis, from, to);
        LaneSpan span{x_of_value(axis, from), x_of_value(axis, to), infinity, -infinity};
        for (std::uint32_t step = here.first; step <= here.last; ++step) {
            if (!std::isfinite(values[step - 1])) continue;
            span.low = std::min(span.low, values[step - 1]);
            span.high = std::max(span.high, values[step - 1]);
        }
        if (span.low <= span.high) add(spans, span);
    }
    return spans;
}

}  // namespace sightline
