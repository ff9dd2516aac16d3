// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cells/cells_report.h"

#include <algorithm>
#include <cmath>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/session/settings_file.h"
#include "lab/report/method_looks.h"
#include "lab/report/page.h"

namespace sightline::lab {

namespace {

/// "tree, split_for=opacity"
std::string kind_of(const CellsCurve& curve) {
    return std::string(word(curve.method.tessellation)) + (curve.also.empty() ? "" : ", " + curve.also);
}

/// How kinds of cells look where they are what differs: a colour for each, as methods have.
std::vector<VariantLook> kind_looks(const std::vector<const CellsCurve*>& curves) {
    std::vector<std::string> texts;
    for (const CellsCurve* curve : curves) {
        std::string text = kind_of(*curve);
        std::replace(text.begin(), text.end(), ' ', '+');
        texts.push_back(text);
    }
    return variant_looks(texts);
}

bool of_one_method(const std::vector<const CellsCurve*>& curves) {
    return std::all_of(curves.begin(), curves.end(), [&](const CellsCurve* curve) {
        return curve->method.variant == curves.front()->method.variant;
    });
}

/// Curves of one scene and path over the number of cells: of several methods, each by its look, or of one by kinds of
/// cells.
Chart chart_of(const std::vector<const CellsCurve*>& curves, Measure measure, double within, bool knees) {
    const bool share = measure_row(measure).unit == "share";
    Chart chart;
    chart.title = curves.front()->scene + ", path " + curves.front()->path + ", budget " + curves.front()->budget;
    chart.x = "cells";
    chart.y = std::string(measure_row(measure).title) + ", " + (share ? "%" : std::string(measure_row(measure).unit));
    chart.log_x = true;
    Series marks{"knee", {{}, {}, ChartMarker::square}, Series::Shown::markers, 2, {}, {}};
    const MethodLooks looks = MethodLooks::of(curves);
    const bool by_kind = curves.size() > 1 && of_one_method(curves);
    const std::vector<VariantLook> kinds = kind_looks(curves);
    if (by_kind) chart.title += ", " + curves.front()->method.variant;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const CellsCurve& curve = *curves[i];
        Series s = looks.series(curve.method);
        if (by_kind) {
            s.name = kind_of(curve);
            s.look = kinds[i];
        }
        for (const CellsPoint& point : curve.points)
            s.points.push_back({static_cast<double>(point.row.cells), summary(point.row, measure) * (share ? 100 : 1)});
        if (knees) marks.points.push_back(s.points[knee(curve, measure, within)]);
        chart.series.push_back(std::move(s));
    }
    if (knees) chart.series.push_back(std::move(marks));
    return chart;
}

std::string table_of(const CellsCurve& curve, Measure measure, double within) {
    const std::size_t at = knee(curve, measure, within);
    std::string html =
        "<h3>" + escaped(method_text(curve.method) + (curve.also.empty() ? "" : ", " + curve.also)) +
        "</h3><table><tr><th>error bound</th><th>cells</th><th>memory, KB</th><th>coverage, %</th>"
        "<th>wrong pixels, %</th><th>worst, %</th><th>traversal, ms</th><th>ms per frame</th>"
        "<th>a line crosses</th><th>an eye ray</th><th>empty, %</th><th>|c|</th><th>spread</th><th></th></tr>";
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const Row& row = curve.points[i].row;
        const CellNumbers& numbers = row.tessellation;
        html += "<tr>" + cell(short_number(curve.points[i].error_bound)) + cell(std::to_string(row.cells)) +
                cell(std::to_string(row.memory_bytes / 1024)) + cell(per_cent(summary(row, Measure::coverage))) +
                cell(per_cent(summary(row, Measure::wrong))) + cell(per_cent(worst(row, Measure::wrong))) +
                cell(number(summary(row, Measure::traverse_ms))) + cell(number(summary(row, Measure::total_ms))) +
                cell(number(numbers.lines.mean)) + cell(number(numbers.eye_rays.mean)) +
                cell(per_cent(numbers.density.empty)) + cell(number(numbers.density.mean)) +
                cell(number(numbers.density.deviation)) + cell(i == at ? "knee" : "", true) + "</tr>";
    }
    return html + "</table><p>Knee: " + knee_text(curve, at) + ".</p>";
}

/// How many cells hold how many primitives, on each kind of cells at the first curve's knee.
Chart density_chart(const std::vector<const CellsCurve*>& curves, Measure measure, double within) {
    Chart chart;
    chart.title = curves.front()->scene + ": primitives in a cell";
    chart.x = "|c|, from this to twice as many";
    chart.y = "cells, % of those that hold any";
    chart.log_x = true;
    const std::vector<VariantLook> kinds = kind_looks(curves);
    std::vector<std::string> done;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const CellsCurve* const curve = curves[c];
        if (std::find(done.begin(), done.end(), kind_of(*curve)) != done.end()) continue;
        done.push_back(kind_of(*curve));
        const Row& row = curve->points[knee(*curve, measure, within)].row;
        const std::vector<std::uint32_t>& histogram = row.tessellation.density.histogram;
        double all = 0;
        for (std::size_t i = 1; i < histogram.size(); ++i) all += histogram[i];
        Series s;
        s.name = kind_of(*curve) + ", " + std::to_string(row.cells) + " cells";
        s.look = kinds[c];
        for (std::size_t i = 1; i < histogram.size(); ++i)
            s.points.push_back({std::ldexp(1.0, static_cast<int>(i) - 1), 100 * histogram[i] / all});
        chart.series.push_back(std::move(s));
    }
    return chart;
}

/// Curves of one scene, path and budget, in their order.
std::vector<std::vector<const CellsCurve*>> grouped(const std::vector<CellsCurve>& curves) {
    std::vector<std::vector<const CellsCurve*>> groups;
    for (const CellsCurve& curve : curves) {
        const auto same = [&](const std::vector<const CellsCurve*>& group) {
            const CellsCurve& first = *group.front();
            return first.scene == curve.scene && first.path == curve.path && first.budget == curve.budget;
        };
        const auto at = std::find_if(groups.begin(), groups.end(), same);
        at == groups.end() ? groups.push_back({&curve}) : at->push_back(&curve);
    }
    return groups;
}

/// For a chart each: all together where each method is on cells of one kind, else method by method.
std::vector<std::vector<const CellsCurve*>> charted(const std::vector<const CellsCurve*>& group) {
    std::vector<std::vector<const CellsCurve*>> by_method;
    for (const CellsCurve* curve : group) {
        const auto same = [&](const auto& some) { return some.front()->method.variant == curve->method.variant; };
        const auto at = std::find_if(by_method.begin(), by_method.end(), same);
        at == by_method.end() ? by_method.push_back({curve}) : at->push_back(curve);
    }
    if (by_method.size() == group.size()) return {group};
    return by_method;
}

}  // namespace

void write_cells_report(const std::vector<CellsCurve>& curves, Measure measure, double within,
                        const std::filesystem::path& folder, const ChartFormat& format) {
    std::filesystem::create_directories(folder / "charts");
    std::string html =
        "<p>Accuracy and time against the number of cells, mean over the frames of the path. The knee is "
        "the coarsest tessellation whose " +
        escaped(std::string(measure_row(measure).title)) + " is within " + per_cent(within) +
        " points of the best.</p><p>A random line crosses so many cells in the mean (the stabbing number of TVCG 3.1: "
        "the fewer, the cheaper the way to what is visible), a ray from an eye of the path to the border so many. "
        "TVCG 3 wants about the same number of primitives in every cell: |c| is its mean over the cells that hold any, "
        "the spread its standard deviation over that mean, 0 if all hold the same.</p>";
    std::vector<Measure> shown{measure};
    for (const Measure m : {Measure::coverage, Measure::traverse_ms, Measure::total_ms})
        if (m != measure) shown.push_back(m);
    for (const auto& group : grouped(curves)) {
        const CellsCurve& first = *group.front();
        html += "<h2>" + escaped(first.scene + ", path " + first.path + ", budget " + first.budget) + "</h2>";
        for (const Measure m : shown) {
            const auto charts = charted(group);
            for (const auto& curves_of_chart : charts) {
                const std::string of =
                    charts.size() > 1 ? "-" + curves_of_chart.front()->method.variant : std::string();
                const std::filesystem::path stem = folder / "charts" /
                                                   file_stem("cells-" + first.scene + "-" + first.path + "-" +
                                                             first.budget + of + "-" + std::string(measure_row(m).id));
                write_chart(chart_of(curves_of_chart, m, within, m == measure), stem, format);
                html += picture(stem.string() + ".svg", "");
            }
        }
        const std::filesystem::path stem =
            folder / "charts" / file_stem("cells-" + first.scene + "-" + first.path + "-" + first.budget + "-density");
        write_chart(density_chart(group, measure, within), stem, format);
        html += picture(stem.string() + ".svg", "");
        for (const CellsCurve* curve : group) html += table_of(*curve, measure, within);
    }
    write_file(folder / "cells.html", page("How many cells a scene needs", html));
}

std::string knee_settings(const CellsCurve& curve, Measure measure, double within) {
    return point_settings(curve, knee(curve, measure, within), measure, within, "of the best error bound tried");
}

std::string point_settings(const CellsCurve& curve, std::size_t at, Measure measure, double within,
                           const std::string& of_what) {
    const std::string why = "The fewest cells (" + knee_text(curve, at) + ") with " +
                            std::string(measure_row(measure).title) + " within " + short_number(within) + " " +
                            of_what + ", on " + curve.scene + ", path " + curve.path + ", budget " + curve.budget + ".";
    std::vector<std::string> settings{"method=" + curve.method.variant, "budget=" + curve.budget,
                                      "tessellation=" + std::string(word(curve.method.tessellation)),
                                      "error_bound=" + number_text(curve.points[at].error_bound)};
    if (!curve.also.empty()) settings.push_back(curve.also);
    return write_settings(settings, why);
}

}  // namespace sightline::lab
