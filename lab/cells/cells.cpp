// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cells/cells.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/methods/method_table.h"

namespace sightline::lab {

namespace {

bool orders_cells(const Study& study, const MethodChoice& choice) {
    const Method<3>* const in_3d = method_of<3>(study.tables, choice);
    const Method<2>* const in_2d = method_of<2>(study.tables, choice);
    return in_3d ? in_3d->orders_cells() : in_2d && in_2d->orders_cells();
}

bool at_least_as_good(Measure measure, double value, double target) {
    return measure_row(measure).better == Better::higher ? value >= target : value <= target;
}

}  // namespace

std::vector<double> default_error_bounds() { return {0.8, 0.4, 0.2, 0.1, 0.05, 0.025}; }

Study sweep_study(Study study, std::vector<double> error_bounds) {
    std::erase_if(study.methods, [&](const MethodChoice& choice) { return !orders_cells(study, choice); });
    std::sort(error_bounds.rbegin(), error_bounds.rend());
    error_bounds.erase(std::unique(error_bounds.begin(), error_bounds.end()), error_bounds.end());
    study.error_bounds = std::move(error_bounds);
    return study;
}

Study cell_free_study(Study study) {
    std::erase_if(study.methods, [&](const MethodChoice& choice) { return orders_cells(study, choice); });
    return study;
}

std::vector<CellsCurve> curves_of(const Results& results) {
    std::vector<CellsCurve> curves;
    for (const Row& row : results.rows) {
        auto at = std::find_if(curves.begin(), curves.end(), [&](const CellsCurve& c) {
            return c.scene == row.scene && c.path == row.path && c.method == row.method && c.budget == row.budget;
        });
        if (at == curves.end()) at = curves.insert(at, {row.scene, row.path, row.method, row.budget, {}});
        at->points.push_back({row.error_bound, row});
    }
    return curves;
}

std::size_t knee(const CellsCurve& curve, Measure measure, double within) {
    const bool higher = measure_row(measure).better == Better::higher;
    double best = std::numeric_limits<double>::quiet_NaN();
    for (const CellsPoint& point : curve.points) {
        const double value = summary(point.row, measure);
        if (std::isnan(best) || (higher ? value > best : value < best)) best = value;
    }
    const double target = higher ? best - within : best + within;
    std::size_t found = 0;
    bool any = false;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        if (!at_least_as_good(measure, summary(curve.points[i].row, measure), target)) continue;
        if (!any || curve.points[i].row.cells < curve.points[found].row.cells) found = i;
        any = true;
    }
    return found;
}

std::string knee_text(const CellsCurve& curve, std::size_t knee) {
    const std::uint32_t cells = curve.points[knee].row.cells;
    const bool coarsest = std::none_of(curve.points.begin(), curve.points.end(),
                                       [&](const CellsPoint& point) { return point.row.cells < cells; });
    return std::to_string(cells) + " cells" + (coarsest ? ", the coarsest tried" : "");
}

std::size_t complexity(const MethodChoice& method) {
    static constexpr std::array simple{"everything", "view", "centroid", "layers"};
    const auto at = std::find(simple.begin(), simple.end(), method.id());
    if (at != simple.end()) return static_cast<std::size_t>(at - simple.begin());
    std::size_t place = simple.size();
    for (const Method<3>& row : method_table<3>()) {
        if (row.id == method.id()) break;
        ++place;
    }
    return place;
}

const Row* simplest(const std::vector<const Row*>& rows, Measure measure, double target) {
    const Row* found = nullptr;
    const auto cost = [](const Row& row) {
        const double ms = summary(row, Measure::total_ms);
        return std::isnan(ms) ? summary(row, Measure::rendered) : ms;
    };
    for (const Row* row : rows) {
        if (!at_least_as_good(measure, summary(*row, measure), target)) continue;
        const auto key = [&](const Row& r) { return std::tuple(complexity(r.method), r.cells, cost(r)); };
        if (!found || key(*row) < key(*found)) found = row;
    }
    return found;
}

}  // namespace sightline::lab
