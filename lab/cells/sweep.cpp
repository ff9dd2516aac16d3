// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cells/sweep.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/session/settings_file.h"
#include "lab/report/method_looks.h"
#include "lab/report/page.h"

namespace sightline::lab {

namespace {

bool has_parameter(const Study& study, const MethodChoice& choice, const std::string& name) {
    const Method<3>* const in_3d = method_of<3>(study.tables, choice);
    const Method<2>* const in_2d = method_of<2>(study.tables, choice);
    return (in_3d && in_3d->parameter(name)) || (in_2d && in_2d->parameter(name));
}

/// Without a value of the parameter.
MethodChoice without(const MethodChoice& choice, const std::string& parameter) {
    VariantText text = read_variant(choice.variant);
    std::erase_if(text.assignments, [&](const auto& assignment) { return assignment.first == parameter; });
    MethodChoice made = choice;
    made.variant = text.text();
    return made;
}

/// The method with that value, whatever it says of the parameter itself.
MethodChoice with_value(const Study& study, const MethodChoice& choice, const std::string& parameter,
                        const std::string& value) {
    MethodChoice made = without(choice, parameter);
    VariantText text = read_variant(made.variant);
    text.assignments.emplace_back(parameter, value);
    made.variant = method_of<3>(study.tables, choice) ? make_variant<3>(study.tables.in_3d, text.text()).text
                                                      : make_variant<2>(study.tables.in_2d, text.text()).text;
    return made;
}

/// All values as numbers, or nothing.
std::vector<double> numbers_of(const std::vector<std::string>& values) {
    std::vector<double> numbers;
    for (const std::string& value : values) {
        const std::optional<double> number = parse_number(value);
        if (!number) return {};
        numbers.push_back(*number);
    }
    return numbers;
}

Chart sweep_chart(const std::vector<const SweepCurve*>& curves, Measure measure, bool is_judge) {
    const SweepCurve& first = *curves.front();
    const bool is_share = measure_row(measure).unit == "share";
    const std::vector<double> numbers = numbers_of(first.values);
    Chart chart;
    chart.title = first.scene + ", path " + first.path + ", budget " + first.budget;
    chart.x = first.parameter;
    chart.y =
        std::string(measure_row(measure).title) + ", " + (is_share ? "%" : std::string(measure_row(measure).unit));
    chart.log_x = !numbers.empty() && std::all_of(numbers.begin(), numbers.end(), [](double n) { return n > 0; });
    Series marks{"best", {{}, {}, ChartMarker::square}, Series::Shown::markers, 2, {}, {}};
    const MethodLooks looks = MethodLooks::of(curves);
    for (const SweepCurve* const curve : curves) {
        Series s = looks.series(curve->method);
        for (std::size_t i = 0; i < curve->rows.size(); ++i) {
            const double x = numbers.empty() ? static_cast<double>(i) : numbers[i];
            s.points.push_back({x, summary(curve->rows[i], measure) * (is_share ? 100 : 1)});
            if (numbers.empty()) s.labels.push_back(curve->values[i]);
        }
        if (is_judge) marks.points.push_back(s.points[best(*curve, measure)]);
        chart.series.push_back(std::move(s));
    }
    if (is_judge) chart.series.push_back(std::move(marks));
    return chart;
}

std::string sweep_table(const SweepCurve& curve, Measure measure) {
    std::string html = "<h3>" + escaped(method_text(curve.method)) + "</h3><table><tr><th class=t>" +
                       escaped(curve.parameter) +
                       "</th><th>drawn</th><th>drawn / V</th><th>tested</th><th>coverage, %</th><th>wrong pixels, %"
                       "</th><th>traversal, ms</th><th>ms per frame</th><th></th></tr>";
    for (std::size_t i = 0; i < curve.rows.size(); ++i) {
        const Row& row = curve.rows[i];
        html += "<tr>" + cell(curve.values[i], true);
        for (const Measure m : {Measure::rendered, Measure::emitted_over_visible, Measure::tested})
            html += cell(number(summary(row, m)));
        for (const Measure m : {Measure::coverage, Measure::wrong}) html += cell(per_cent(summary(row, m)));
        for (const Measure m : {Measure::traverse_ms, Measure::total_ms}) html += cell(number(summary(row, m)));
        html += cell(i == best(curve, measure) ? "best" : "", true) + "</tr>";
    }
    return html + "</table>";
}

}  // namespace

Sweep parse_sweep(const std::string& text) {
    const std::size_t equals = text.find('=');
    Sweep sweep;
    if (equals != std::string::npos) {
        sweep.parameter = text.substr(0, equals);
        for (std::size_t begin = equals + 1; begin <= text.size();) {
            const std::size_t comma = std::min(text.find(',', begin), text.size());
            sweep.values.push_back(text.substr(begin, comma - begin));
            begin = comma + 1;
        }
    }
    const bool has_empty = std::find(sweep.values.begin(), sweep.values.end(), "") != sweep.values.end();
    if (sweep.parameter.empty() || sweep.values.size() < 2 || has_empty)
        throw InputError("--sweep '" + excerpt(text) +
                         "': write PARAMETER=VALUE,VALUE,… such as occluder_count=8,16,32");
    return sweep;
}

Study parameter_study(Study study, const std::vector<Sweep>& sweeps) {
    std::vector<MethodChoice> methods;
    for (const Sweep& sweep : sweeps) {
        bool any = false;
        for (const MethodChoice& choice : study.methods) {
            if (!has_parameter(study, choice, sweep.parameter)) continue;
            any = true;
            for (const std::string& value : sweep.values) {
                MethodChoice made = with_value(study, choice, sweep.parameter, value);
                if (std::find(methods.begin(), methods.end(), made) == methods.end())
                    methods.push_back(std::move(made));
            }
        }
        if (!any)
            throw InputError("--sweep " + excerpt(sweep.parameter) + ": none of these methods has such a parameter");
    }
    study.methods = std::move(methods);
    return study;
}

std::vector<SweepCurve> sweep_curves(const Study& study, const std::vector<Sweep>& sweeps, const Results& results) {
    std::vector<SweepCurve> curves;
    for (const Sweep& sweep : sweeps)
        for (const MethodChoice& choice : study.methods) {
            if (!has_parameter(study, choice, sweep.parameter)) continue;
            const std::size_t begin = curves.size();
            for (const std::string& value : sweep.values) {
                const MethodChoice swept = with_value(study, choice, sweep.parameter, value);
                for (const Row& row : results.rows) {
                    if (row.method != swept) continue;
                    auto at = std::find_if(curves.begin() + static_cast<std::ptrdiff_t>(begin), curves.end(),
                                           [&](const SweepCurve& curve) {
                                               return curve.scene == row.scene && curve.path == row.path &&
                                                      curve.budget == row.budget;
                                           });
                    if (at == curves.end())
                        at = curves.insert(at, {row.scene,
                                                row.path,
                                                without(choice, sweep.parameter),
                                                sweep.parameter,
                                                row.budget,
                                                {},
                                                {}});
                    at->values.push_back(value);
                    at->rows.push_back(row);
                }
            }
        }
    return curves;
}

std::size_t best(const SweepCurve& curve, Measure measure) {
    const bool higher = measure_row(measure).better == Better::higher;
    std::size_t found = 0;
    for (std::size_t i = 1; i < curve.rows.size(); ++i) {
        const double value = summary(curve.rows[i], measure), least = summary(curve.rows[found], measure);
        if (std::isnan(least) || (higher ? value > least : value < least)) found = i;
    }
    return found;
}

void write_sweep_report(const std::vector<SweepCurve>& curves, Measure measure, const std::filesystem::path& folder,
                        const ChartFormat& format) {
    std::filesystem::create_directories(folder / "charts");
    std::string html =
        "<p>Each method over the values of one parameter, all else as it is, mean over the frames of the path (times: "
        "median). Judged by " +
        escaped(std::string(measure_row(measure).title)) + ". Charts of a measure that no row has are left out.</p>";
    std::vector<Measure> shown{measure};
    for (const Measure m : {Measure::rendered, Measure::tested, Measure::traverse_ms, Measure::total_ms})
        if (m != measure) shown.push_back(m);
    std::vector<std::vector<const SweepCurve*>> groups;
    for (const SweepCurve& curve : curves) {
        const auto at = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
            const SweepCurve& first = *group.front();
            return first.scene == curve.scene && first.path == curve.path && first.budget == curve.budget &&
                   first.parameter == curve.parameter;
        });
        at == groups.end() ? groups.push_back({&curve}) : at->push_back(&curve);
    }
    for (const auto& group : groups) {
        const SweepCurve& first = *group.front();
        html += "<h2>" +
                escaped(first.parameter + ": " + first.scene + ", path " + first.path + ", budget " + first.budget) +
                "</h2>";
        for (const Measure m : shown) {
            const bool any = std::any_of(group.begin(), group.end(), [&](const SweepCurve* curve) {
                return std::any_of(curve->rows.begin(), curve->rows.end(),
                                   [&](const Row& row) { return !std::isnan(summary(row, m)); });
            });
            if (!any) continue;
            const std::filesystem::path stem =
                folder / "charts" /
                file_stem("sweep-" + first.parameter + "-" + first.scene + "-" + first.path + "-" + first.budget + "-" +
                          std::string(measure_row(m).id));
            write_chart(sweep_chart(group, m, m == measure), stem, format);
            html += picture(stem.string() + ".svg", "");
        }
        for (const SweepCurve* const curve : group) html += sweep_table(*curve, measure);
    }
    write_file(folder / "sweep.html", page("What a parameter does", html));
}

std::string sweep_settings(const SweepCurve& curve, Measure measure) {
    const std::size_t at = best(curve, measure);
    const std::string why = "The best " + curve.parameter + " of those tried by " +
                            std::string(measure_row(measure).title) + ", on " + curve.scene + ", path " + curve.path +
                            ", budget " + curve.budget + ".";
    const auto tessellation = words<Tessellation>[static_cast<std::size_t>(curve.method.tessellation)];
    return write_settings({"method=" + curve.rows[at].method.variant, "budget=" + curve.budget,
                           "tessellation=" + std::string(tessellation)},
                          why);
}

}  // namespace sightline::lab
