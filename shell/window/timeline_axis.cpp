// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/timeline_axis.h"

#include <algorithm>
#include <cmath>

namespace sightline {

namespace {

using Ends = std::span<const std::uint32_t>;

double whole(const Ends& ends) { return ends.back(); }
double steps(const Ends& ends) { return static_cast<double>(ends.size() - 1); }

double value_of(const Ends& ends, double step) {
    step = std::clamp(step, 0.0, steps(ends));
    const auto before = static_cast<std::size_t>(step);
    if (before + 1 >= ends.size()) return whole(ends);
    return ends[before] + (step - std::floor(step)) * (ends[before + 1] - ends[before]);
}

/// Gives back a value's step such that value_of(step) is the value again.
double step_of(const Ends& ends, double value) {
    value = std::clamp(value, 0.0, whole(ends));
    const auto end = std::lower_bound(ends.begin(), ends.end(), value);
    if (end == ends.begin()) return 0;
    const double before = *(end - 1);
    return static_cast<double>(end - ends.begin() - 1) + (value - before) / (*end - before);
}

double least(const Ends& ends) { return std::min(least_shown, std::max(whole(ends), 1.0)); }

/// `span` long from `from`, moved into the run.
Shares shares(const StepAxis& axis, double from, double span) {
    const Ends& ends = axis.ends;
    if (whole(ends) == 0) return {};
    span = std::clamp(span, least(ends), whole(ends));
    from = std::clamp(from, 0.0, whole(ends) - span);
    return {step_of(ends, from) / steps(ends), step_of(ends, from + span) / steps(ends)};
}

}  // namespace

StepAxis make_axis(Ends ends, const Shares& shown, float x, float w) {
    StepAxis axis{ends, value_of(ends, shown.from * steps(ends)), value_of(ends, shown.to * steps(ends)), x,
                  std::max(w, 1.0f)};
    const double shortest = least(ends), missing = shortest - (axis.to - axis.from);
    if (missing > 0) {
        axis.from = std::clamp(axis.from - missing / 2, 0.0, std::max(whole(ends) - shortest, 0.0));
        axis.to = axis.from + shortest;
    }
    return axis;
}

float x_of_value(const StepAxis& axis, double value) {
    return axis.x + static_cast<float>((value - axis.from) / (axis.to - axis.from) * axis.w);
}

double value_at(const StepAxis& axis, float x) {
    return axis.from + double{x - axis.x} / axis.w * (axis.to - axis.from);
}

float x_of_step(const StepAxis& axis, std::uint32_t step) { return x_of_value(axis, axis.ends[step]); }

float middle_of_step(const StepAxis& axis, std::uint32_t step) {
    return x_of_value(axis, step == 0 ? 0 : (static_cast<double>(axis.ends[step - 1]) + axis.ends[step]) / 2);
}

std::uint32_t step_at(const StepAxis& axis, float x) {
    return static_cast<std::uint32_t>(std::ceil(step_of(axis.ends, value_at(axis, x))));
}

std::uint32_t nearest_step(const StepAxis& axis, float x) {
    const std::uint32_t step = step_at(axis, x);
    if (step == 0) return 0;
    return std::abs(x_of_step(axis, step - 1) - x) < std::abs(x_of_step(axis, step) - x) ? step - 1 : step;
}

StepRange steps_between(const StepAxis& axis, double from, double to) {
    const Ends& ends = axis.ends;
    auto first = std::lower_bound(ends.begin(), ends.end(), from) - ends.begin();
    const auto end = [&](std::ptrdiff_t step) { return ends[static_cast<std::size_t>(step)]; };
    // The one that ends at `from` lies before it, unless it has no width.
    if (first == 0 || (first < std::ssize(ends) && end(first) == from && end(first - 1) < from)) ++first;
    const auto beyond = std::upper_bound(ends.begin(), ends.end(), to);
    auto last = beyond - ends.begin() - 1;  // the last that ends here; the next one begins here unless it ended at `to`
    if (beyond != ends.end() && (last < 0 || end(last) < to)) ++last;
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(std::max(last, std::ptrdiff_t{0}))};
}

Shares zoomed(const StepAxis& axis, float x, double factor) {
    const double span = std::clamp((axis.to - axis.from) / factor, least(axis.ends), std::max(whole(axis.ends), 1.0));
    return shares(axis, value_at(axis, x) - double{x - axis.x} / axis.w * span, span);
}

Shares panned(const StepAxis& axis, float dx) {
    const double span = axis.to - axis.from;
    return shares(axis, axis.from - double{dx} / axis.w * span, span);
}

Shares centred(const StepAxis& axis, std::uint32_t step) {
    const double span = axis.to - axis.from;
    return shares(axis, axis.ends[step] - span / 2, span);
}

std::vector<double> nice_values(const StepAxis& axis, float gap) {
    const double least_step = gap / axis.w * (axis.to - axis.from);
    double step = 1;
    for (int i = 0; step < least_step; ++i) step *= i % 3 == 1 ? 2.5 : 2;  // 1, 2, 5, 10, …
    std::vector<double> values;
    for (double k = std::ceil(axis.from / step); k * step <= axis.to; ++k) values.push_back(k * step);
    return values;
}

}  // namespace sightline
