// Several frames in one number, and what is best when speed and accuracy both count.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/measure/measure_table.h"

namespace sightline {

/// NaN of nothing.
double median(std::vector<double> values);

/// Where a share of the values lies below, interpolated between neighbours in order: 0 the least, 0.5 the median, 1 the
/// largest. NaN of nothing.
double quantile(std::vector<double> values, double share);

/// How values lie.
struct Spread {
    double mean, lower_quartile, median, upper_quartile;
};
Spread spread(const std::vector<double>& values);

/// s / sqrt(n), s with n - 1; NaN for fewer than two values.
double standard_error(std::span<const double> values);

/// The mean over frames, the median for times; frames without a value are left out. NaN where none has one.
double summary(std::span<const Values> frames, Measure measure);

/// What a method costs and what it achieves.
struct Trade {
    double ms = 0, value = 0;
};

/// Indices of those that no other one beats in both, by time. Those without a time or a value are left out; equal ones
/// are all there. `better`: higher or lower values.
std::vector<std::size_t> pareto_points(std::span<const Trade> trades, Better better);

}  // namespace sightline
