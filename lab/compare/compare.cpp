// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/text.h"

namespace sightline::lab {

namespace {

/// Two-sided 95 % quantile of Student's t for so many degrees of freedom.
double t_95(std::size_t degrees) {
    static constexpr std::array table{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                      2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                                      2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
    if (degrees == 0) return std::numeric_limits<double>::infinity();
    if (degrees <= table.size()) return table[degrees - 1];
    return 1.96 + 2.5 / static_cast<double>(degrees);  // within 0.003 of the quantile from 30 on
}

Pair pair_of(const Row& a, const Row& b) {
    Pair pair{&a, &b, {}};
    for (const MeasureRow& m : measure_table())
        if (m.better != Better::neither)
            if (const auto change = change_of(a, b, m.measure)) pair.changes.push_back(*change);
    return pair;
}

std::set<std::string> methods_of(const Results& results) {
    std::set<std::string> methods;
    for (const Row& row : results.rows) methods.insert(method_text(row.method));
    return methods;
}

/// Whether one scene, path, method and budget is there with several error bounds.
bool sweeps(const Results& results) {
    for (const Row& row : results.rows)
        for (const Row& other : results.rows)
            if (row.scene == other.scene && row.path == other.path && row.method == other.method &&
                row.budget == other.budget && row.error_bound != other.error_bound)
                return true;
    return false;
}

/// Methods that no heuristic touches. Others may be conservative too, and change.
bool is_control(const MethodChoice& method) {
    return method.variant == view_culling || method.variant == "everything" || method.variant == exactly_v;
}

}  // namespace

double confidence_half_width(const std::vector<double>& values) {
    if (values.size() < 2) return 0;
    const auto n = static_cast<double>(values.size());
    double mean = 0, squares = 0, neighbours = 0;
    for (const double v : values) mean += v / n;
    for (std::size_t i = 0; i < values.size(); ++i) {
        squares += (values[i] - mean) * (values[i] - mean);
        if (i > 0) neighbours += (values[i] - mean) * (values[i - 1] - mean);
    }
    if (squares == 0) return 0;
    const double r = std::max(neighbours / squares, 0.0);
    const double count = std::max(n * (1 - r) / (1 + r), 1.0);
    return t_95(values.size() - 1) * std::sqrt(squares / (n - 1) / count);
}

std::optional<Change> change_of(const Row& a, const Row& b, Measure measure) {
    Change change;
    change.measure = measure;
    std::vector<double> differences;
    std::vector<std::size_t> at;
    double sum_a = 0, sum_b = 0, squared_errors = 0;
    const auto error = error_of(measure);
    for (std::size_t i = 0; i < a.frames.size(); ++i) {
        const auto found = std::find(b.frames.begin(), b.frames.end(), a.frames[i]);
        if (found == b.frames.end()) continue;
        const Values &of_a = a.values[i], &of_b = b.values[static_cast<std::size_t>(found - b.frames.begin())];
        const double x = of_a[measure], y = of_b[measure];
        if (std::isnan(x) || std::isnan(y)) continue;
        if (error) squared_errors += of_a[*error] * of_a[*error] + of_b[*error] * of_b[*error];
        differences.push_back(y - x);
        at.push_back(i);
        sum_a += x;
        sum_b += y;
    }
    if (differences.empty()) return std::nullopt;
    const auto n = static_cast<double>(differences.size());
    change.frames = differences.size();
    change.a = sum_a / n;
    change.b = sum_b / n;
    for (const double d : differences) change.mean += d / n;
    change.half_width = confidence_half_width(differences);
    if (error && std::isnan(squared_errors) && differences.size() == 1)
        change.half_width = std::numeric_limits<double>::infinity();  // timed once: nothing says how well
    else if (error && !std::isnan(squared_errors))
        change.half_width = std::max(change.half_width, t_95(2 * differences.size()) * std::sqrt(squared_errors) / n);
    const auto [least, most] = std::minmax_element(differences.begin(), differences.end());
    const std::size_t low = at[static_cast<std::size_t>(least - differences.begin())];
    const std::size_t high = at[static_cast<std::size_t>(most - differences.begin())];
    const bool higher = measure_row(measure).better == Better::higher;
    change.lost = higher ? low : high;
    change.gained = higher ? high : low;
    return change;
}

std::optional<double> machine_change(const std::vector<Pair>& pairs, const std::string& scene,
                                     const std::string& path) {
    std::optional<double> most;
    for (const Pair& pair : pairs) {
        if (!is_control(pair.a->method) || pair.a->method != pair.b->method) continue;
        if (pair.a->scene != scene || pair.a->path != path) continue;
        for (const Change& change : pair.changes)
            if (change.measure == Measure::total_ms && change.a > 0)
                most = std::max(most.value_or(0), (std::abs(change.mean) + change.half_width) / change.a);
    }
    return most;
}

std::vector<Pair> compare_results(const Results& a, const Results& b) {
    const auto methods_a = methods_of(a), methods_b = methods_of(b);
    const bool one_each = methods_a.size() == 1 && methods_b.size() == 1;
    const bool sweep_a = sweeps(a), sweep_b = sweeps(b);
    std::vector<Pair> pairs;
    for (const Row& x : a.rows)
        for (const Row& y : b.rows) {
            if (x.scene != y.scene || x.path != y.path || x.budget != y.budget) continue;
            if ((sweep_a || sweep_b) && x.error_bound != y.error_bound) continue;
            if (!one_each && x.method != y.method) continue;
            pairs.push_back(pair_of(x, y));
            break;
        }
    if (pairs.empty()) throw InputError("compare: the two studies have no scene, path, method and budget in common");
    for (Pair& pair : pairs)
        if (const auto share = machine_change(pairs, pair.a->scene, pair.a->path))
            for (Change& change : pair.changes)
                if (measure_row(change.measure).is_time) change.machine = *share * change.a;
    return pairs;
}

std::vector<Pair> compare_methods(const Results& results, const MethodChoice& a, const MethodChoice& b) {
    std::vector<Pair> pairs;
    // A method that is conservative, or takes no budget, stands beside each budget of the other.
    const auto takes_budgets = [&](const Row& row) { return row.approximate && row.budget != "unlimited"; };
    for (const Row& x : results.rows)
        for (const Row& y : results.rows) {
            const bool budgets = x.budget == y.budget || !takes_budgets(x) || !takes_budgets(y);
            const bool same = x.scene == y.scene && x.path == y.path && x.error_bound == y.error_bound && budgets;
            if (same && x.method == a && y.method == b) pairs.push_back(pair_of(x, y));
        }
    if (pairs.empty())
        throw InputError("compare: the study does not hold " + excerpt(method_text(a)) + " and " +
                         excerpt(method_text(b)) + " at the same budget");
    return pairs;
}

}  // namespace sightline::lab
