// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cells.h"

#include <algorithm>
#include <cmath>

#include "core/number.h"
#include "core/traversal/methods.h"
#include "lab/measure_path.h"

namespace sightline::lab {

namespace {

bool orders_cells(const std::string& id) {
    for (const Method<3>& method : method_table<3>())
        if (method.id == id) return method.orders_cells;
    return false;
}

template <int D>
std::vector<Row> rows_at(const std::string& scene, const std::string& path, const Study& study, LabGraphics& graphics) {
    const LabScene<D> lab = load_lab_scene<D>(scene, path, study);
    Instruments instruments;
    instruments.draw_ids = graphics.draw_ids();
    instruments.time_drawing = graphics.time_drawing(study.size);
    return measure_path<D>(lab, study, instruments);
}

bool at_least_as_good(Measure measure, double value, double target) {
    return measure_row(measure).better == Better::higher ? value >= target : value <= target;
}

}  // namespace

std::vector<double> default_error_bounds() { return {0.4, 0.28, 0.2, 0.14, 0.1, 0.07, 0.05, 0.035, 0.025}; }

std::vector<CellsCurve> sweep_cells(const Study& asked, const std::vector<double>& error_bounds, LabGraphics& graphics,
                                    const std::function<void(const std::string&)>& say) {
    Study study = asked;
    std::erase_if(study.methods, [](const MethodChoice& choice) { return !orders_cells(choice.id); });
    std::vector<double> bounds = error_bounds;
    std::sort(bounds.rbegin(), bounds.rend());
    std::vector<CellsCurve> curves;
    for (const std::string& scene : study.scenes)
        for (const std::string& path : study.paths) {
            const std::size_t first = curves.size();
            for (const double bound : bounds) {
                if (say) say(scene + ": error bound " + short_number(bound));
                Study one = study;
                one.settings.push_back("error_bound=" + number_text(bound));
                std::vector<Row> rows = parse_scene(scene).dimension == 2 ? rows_at<2>(scene, path, one, graphics)
                                                                          : rows_at<3>(scene, path, one, graphics);
                for (std::size_t i = 0; i < rows.size(); ++i) {
                    if (curves.size() == first + i)
                        curves.push_back({rows[i].scene, rows[i].path, rows[i].method, rows[i].budget, {}});
                    curves[first + i].points.push_back({bound, std::move(rows[i])});
                }
            }
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

std::size_t complexity(const MethodChoice& method) {
    static constexpr std::array simple{"everything", "view", "centroid", "layers"};
    const auto at = std::find(simple.begin(), simple.end(), method.id);
    if (at != simple.end()) return static_cast<std::size_t>(at - simple.begin());
    std::size_t place = simple.size();
    for (const Method<3>& row : method_table<3>()) {
        if (row.id == method.id) break;
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
        const auto key = [&](const Row& r) { return std::pair(complexity(r.method), cost(r)); };
        if (!found || key(*row) < key(*found)) found = row;
    }
    return found;
}

}  // namespace sightline::lab
