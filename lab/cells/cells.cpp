// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cells/cells.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"
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

std::vector<CellsKind> parse_kinds(const std::vector<std::string>& texts) {
    std::vector<CellsKind> known;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < tessellation_count; ++i) {
        const auto tessellation = static_cast<Tessellation>(i);
        const std::string name(word(tessellation));
        const auto add = [&](const char* suffix, const char* also) {
            known.push_back({tessellation, also});
            names.push_back(name + suffix);
        };
        add("", "");
        add("+opacity", "split_for=opacity");
        if (tessellation == Tessellation::delaunay) add("+merge", "empty_leaves=merge");
    }
    if (texts.size() == 1 && texts.front() == "all") return known;
    std::vector<CellsKind> kinds;
    for (const std::string& text : texts) {
        const auto at = std::find(names.begin(), names.end(), text);
        if (at == names.end()) {
            std::string all = "all";
            for (const std::string& name : names) all += ", " + name;
            throw InputError("--cells '" + excerpt(text) + "': write some of " + all);
        }
        const CellsKind& kind = known[static_cast<std::size_t>(at - names.begin())];
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end())
            throw InputError("--cells " + excerpt(text) + ": is given twice");
        kinds.push_back(kind);
    }
    return kinds;
}

std::vector<KindStudy> kind_studies(const Study& sweep, const std::vector<CellsKind>& kinds) {
    std::vector<KindStudy> studies;
    for (const CellsKind& kind : kinds) {
        auto at = std::find_if(studies.begin(), studies.end(), [&](const KindStudy& s) { return s.also == kind.also; });
        if (at == studies.end()) {
            at = studies.insert(at, {kind.also, sweep});
            at->study.methods.clear();
            const std::string field = kind.also.substr(0, kind.also.find('=') + 1);
            for (const std::string& setting : sweep.settings)
                if (!field.empty() && setting.starts_with(field))
                    throw InputError("--set " + excerpt(setting) + ": --cells says that");
            if (!kind.also.empty()) at->study.settings.push_back(kind.also);
        }
        for (const MethodChoice& choice : sweep.methods) {
            const MethodChoice on_kind{choice.variant, kind.tessellation};
            auto& all = at->study.methods;
            if (std::find(all.begin(), all.end(), on_kind) == all.end()) all.push_back(on_kind);
        }
    }
    return studies;
}

Study cell_free_study(Study study) {
    std::erase_if(study.methods, [&](const MethodChoice& choice) { return orders_cells(study, choice); });
    return study;
}

std::vector<CellsCurve> curves_of(const Results& results, const std::string& also) {
    std::vector<CellsCurve> curves;
    for (const Row& row : results.rows) {
        auto at = std::find_if(curves.begin(), curves.end(), [&](const CellsCurve& c) {
            return c.scene == row.scene && c.path == row.path && c.method == row.method && c.budget == row.budget;
        });
        if (at == curves.end()) at = curves.insert(at, {row.scene, row.path, row.method, row.budget, {}, also});
        at->points.push_back({row.error_bound, row});
    }
    return curves;
}

std::size_t knee(const CellsCurve& curve, Measure measure, double within) {
    return coarsest({curve}, curve, measure, within).point;
}

CurvePoint coarsest(const std::vector<CellsCurve>& curves, const CellsCurve& of, Measure measure, double within) {
    const bool higher = measure_row(measure).better == Better::higher;
    double best = std::numeric_limits<double>::quiet_NaN();
    const auto each = [&](const auto& use) {
        for (std::size_t c = 0; c < curves.size(); ++c) {
            const CellsCurve& curve = curves[c];
            if (curve.scene != of.scene || curve.path != of.path || curve.method.variant != of.method.variant ||
                curve.budget != of.budget)
                continue;
            for (std::size_t p = 0; p < curve.points.size(); ++p) use(CurvePoint{c, p}, curve.points[p].row);
        }
    };
    each([&](CurvePoint, const Row& row) {
        const double value = summary(row, measure);
        if (std::isnan(best) || (higher ? value > best : value < best)) best = value;
    });
    const double target = higher ? best - within : best + within;
    CurvePoint found;
    const Row* coarsest_row = nullptr;
    each([&](CurvePoint at, const Row& row) {
        if (!at_least_as_good(measure, summary(row, measure), target)) return;
        if (coarsest_row && row.cells >= coarsest_row->cells) return;
        found = at;
        coarsest_row = &row;
    });
    return found;
}

std::string kind_text(const CellsCurve& curve, std::size_t point) {
    return std::string(word(curve.method.tessellation)) + (curve.also.empty() ? "" : ", " + curve.also) +
           ", error bound " + short_number(curve.points[point].error_bound);
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
