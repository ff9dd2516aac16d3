// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/summary.h"

#include <algorithm>
#include <cmath>

namespace sightline {

double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 >= values.size()) return values.back();
    return values[below] + (values[below + 1] - values[below]) * (place - static_cast<double>(below));
}

Spread spread(const std::vector<double>& values) {
    double mean = values.empty() ? std::numeric_limits<double>::quiet_NaN() : 0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    return {mean, quantile(values, 0.25), median(values), quantile(values, 0.75)};
}

double standard_error(std::span<const double> values) {
    if (values.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    const auto n = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double v : values) mean += v / n;
    for (const double v : values) squares += (v - mean) * (v - mean);
    return std::sqrt(squares / (n - 1) / n);
}

double summary(std::span<const Values> frames, Measure measure) {
    std::vector<double> values;
    for (const Values& v : frames)
        if (!std::isnan(v[measure])) values.push_back(v[measure]);
    if (measure_row(measure).is_time || values.empty()) return median(std::move(values));
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

std::vector<std::size_t> pareto_points(std::span<const Trade> trades, Better better) {
    const auto beats = [&](const Trade& a, const Trade& b) {
        const bool as_good = better == Better::higher ? a.value >= b.value : a.value <= b.value;
        return a.ms <= b.ms && as_good && (a.ms < b.ms || a.value != b.value);
    };
    const auto is_known = [](const Trade& t) { return std::isfinite(t.ms) && std::isfinite(t.value); };
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < trades.size(); ++i)
        if (is_known(trades[i]) && std::none_of(trades.begin(), trades.end(), [&](const Trade& other) {
                return is_known(other) && beats(other, trades[i]);
            }))
            front.push_back(i);
    std::stable_sort(front.begin(), front.end(),
                     [&](std::size_t a, std::size_t b) { return trades[a].ms < trades[b].ms; });
    return front;
}

}  // namespace sightline
