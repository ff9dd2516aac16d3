// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/base/text.h"
#include "lab/cells/cells_report.h"
#include "lab/cells/sweep.h"
#include "lab/command.h"
#include "lab/measure/out_folder.h"
#include "lab/measure/run_study.h"
#include "lab/measure/study_options.h"
#include "lab/report/chart_options.h"
#include "lab/report/say.h"
#include "lab/report/study_charts.h"

namespace sightline::lab {

namespace {

Measure measure_named(const std::string& id) {
    for (const MeasureRow& row : measure_table())
        if (row.id == id && row.better != Better::neither) return row.measure;
    throw InputError("--measure '" + excerpt(id) +
                     "': not a measure that can be better or worse, such as wrong or coverage");
}

/// Writes the settings of a knee and says so.
void write_knee(const CellsCurve& curve, Measure measure, double within, const std::filesystem::path& folder) {
    const std::size_t at = knee(curve, measure, within);
    const CellsPoint& point = curve.points[at];
    const std::filesystem::path file =
        folder / (file_stem(curve.scene + "-" + method_text(curve.method) + "-" + curve.budget +
                            (curve.also.empty() ? "" : "-" + curve.also)) +
                  ".settings.json");
    write_file(file, knee_settings(curve, measure, within));
    std::cout << one_line(curve.scene, 1000) << ", " << method_text(curve.method) << " " << curve.budget
              << (curve.also.empty() ? "" : ", " + curve.also) << ": error bound " << short_number(point.error_bound)
              << ", " << knee_text(curve, at) << ", " << measure_row(measure).title << " "
              << short_number(summary(point.row, measure)) << "; --settings " << shell_quoted(file.string()) << "\n";
}

/// Over all kinds of cells, once for each scene, path, method and budget.
void write_coarsest(const std::vector<CellsCurve>& curves, Measure measure, double within,
                    const std::filesystem::path& folder) {
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const CellsCurve& of = curves[c];
        const auto same = [&](const CellsCurve& other) {
            return other.scene == of.scene && other.path == of.path && other.method.variant == of.method.variant &&
                   other.budget == of.budget;
        };
        if (std::find_if(curves.begin(), curves.end(), same) != curves.begin() + static_cast<std::ptrdiff_t>(c))
            continue;
        const auto text = [&](const CurvePoint& at) {
            const CellsCurve& curve = curves[at.curve];
            const Row& row = curve.points[at.point].row;
            return std::to_string(row.cells) + " cells (" + kind_text(curve, at.point) + "; " +
                   std::string(measure_row(measure).title) + " " + short_number(summary(row, measure)) + ")";
        };
        const CurvePoint at = coarsest(curves, of, measure, within);
        const CellsCurve& curve = curves[at.curve];
        const std::filesystem::path file =
            folder / (file_stem(of.scene + "-" + of.method.variant + "-" + of.budget + "-coarsest") + ".settings.json");
        write_file(file, point_settings(curve, at.point, measure, within, "of the best cells tried"));
        std::cout << one_line(of.scene, 1000) << ", " << of.method.variant << " " << of.budget
                  << ": the coarsest cells that are as good: " << text(at)
                  << "; the best: " << text(coarsest(curves, of, measure, 0)) << "; --settings "
                  << shell_quoted(file.string()) << "\n";
    }
}

/// Empty for a method that needs none.
std::string on_cells(const Row& row, const MethodTables& tables) {
    const Method<3>* const method = method_of<3>(tables, row.method);
    if (!method || !method->orders_cells()) return {};
    return ", " + std::to_string(row.cells) + " cells (error bound " + short_number(row.error_bound) + ")";
}

/// Parameters of methods instead of cells.
int sweep_parameters(const Study& asked, const std::vector<std::string>& texts, Measure measure, std::string out,
                     const ChartFormat& format) {
    std::vector<Sweep> sweeps;
    for (const std::string& text : texts) sweeps.push_back(parse_sweep(text));
    const Study study = parameter_study(asked, sweeps);
    if (out.empty()) out = folder_for(folder_named("cells", name_parts(study)), "frames.jsonl", study_json(study));
    LabGraphics graphics;
    note_interrupts();
    const Results results = run_study(study, out, graphics, {.say = say, .stopped = interrupted});
    if (interrupted()) return stopped();
    write_results(results, out);
    const std::vector<SweepCurve> curves = sweep_curves(asked, sweeps, results);
    say("drawing the charts");
    write_sweep_report(curves, measure, out, format);
    say("");
    for (const SweepCurve& curve : curves) {
        const std::size_t at = best(curve, measure);
        const std::filesystem::path file =
            std::filesystem::path(out) /
            (file_stem(curve.scene + "-" + method_text(curve.method) + "-" + curve.parameter + "-" + curve.budget) +
             ".settings.json");
        write_file(file, sweep_settings(curve, measure));
        std::cout << one_line(curve.scene, 1000) << ", " << method_text(curve.method) << " " << curve.budget << ": "
                  << curve.parameter << " " << curve.values[at] << ", " << measure_row(measure).title << " "
                  << short_number(summary(curve.rows[at], measure)) << "; --settings " << shell_quoted(file.string())
                  << "\n";
    }
    std::cout << "Written: " << one_line(out, 4096)
              << "/sweep.html, results.json, results.csv, charts/, *.settings.json\n";
    return 0;
}

}  // namespace

int cells_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{
        "Sweeps the size of the cells and finds the coarsest tessellation, and the simplest method, that suffice.",
        "lab cells"};
    StudyOptions options;
    options.budgets = {"5%"};
    options.methods = {"published", "layers", "centroid", "view"};
    add_study_options(app, options);
    std::vector<double> bounds = default_error_bounds();
    std::vector<std::string> sweeps, kinds;
    std::string measure_id = "wrong", out;
    double within = 0.01;
    std::optional<double> reach;
    app.add_option("--error-bounds", bounds, "comma-separated, each in (0, 1]")
        ->delimiter(',')
        ->check(CLI::Range(1e-3, 1.0));
    app.add_option("--cells", kinds,
                   "kinds of cells to try instead of those of the methods, comma-separated: delaunay, tree, kd, each "
                   "also with +opacity, delaunay+merge, or all; names the coarsest of all that is as good as the best")
        ->delimiter(',');
    app.add_option(
           "--sweep", sweeps,
           "PARAMETER=VALUE,VALUE,… of a method instead of the size of cells: occluder_count=8,16,32; judged by "
           "ms per frame unless --measure is given; may be given several times")
        ->allow_extra_args(false);
    const CLI::Option* const measure_option =
        app.add_option("--measure", measure_id, "the measure to judge by, such as wrong, coverage or total_ms")
            ->capture_default_str();
    app.add_option("--within", within,
                   "how much worse than the best the knee may be, in units of the measure (shares: 0.01 is 1 %)")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--reach", reach, "also name the simplest method that reaches this value of the measure");
    app.add_option("--out", out, "folder of the results; default: out/cells-SCENE");
    ChartFormat format;
    add_chart_options(app, format);
    if (!parse(app, argc, argv)) return 0;
    if (!sweeps.empty() && measure_option->empty()) measure_id = "total_ms";
    if (!sweeps.empty() && app.get_option("--methods")->empty()) options.methods.clear();  // all that have it
    const Measure measure = measure_named(measure_id);
    const Study asked = study_of(options, tables);
    if (!sweeps.empty()) return sweep_parameters(asked, sweeps, measure, out, format);
    const Study sweep = sweep_study(asked, bounds), cell_free = cell_free_study(asked);
    if (sweep.methods.empty()) throw InputError("lab cells: none of these methods orders cells");
    if (!reach && !app.get_option("--methods")->empty())
        for (const MethodChoice& choice : asked.methods)
            if (std::find(sweep.methods.begin(), sweep.methods.end(), choice) == sweep.methods.end())
                warn(excerpt(method_text(choice)) + ": is left out: it orders no cells; --reach compares it");
    const std::vector<KindStudy> studies =
        kinds.empty() ? std::vector<KindStudy>{{"", sweep}} : kind_studies(sweep, parse_kinds(kinds));
    const Study& first = studies.front().study;
    if (out.empty()) out = folder_for(folder_named("cells", name_parts(first)), "frames.jsonl", study_json(first));
    LabGraphics graphics;
    note_interrupts();
    Results results;
    std::vector<CellsCurve> curves;
    for (const KindStudy& of : studies) {
        const std::filesystem::path folder = &of == &studies.front() ? out : out + "/" + file_stem(of.also);
        const Results found = run_study(of.study, folder, graphics, {.say = say, .stopped = interrupted});
        if (interrupted()) return stopped();
        write_results(found, folder);
        for (CellsCurve& curve : curves_of(found, of.also)) curves.push_back(std::move(curve));
        if (&of == &studies.front()) results.conditions = found.conditions;
        results.rows.insert(results.rows.end(), found.rows.begin(), found.rows.end());
    }
    Results simple = results;
    if (reach && !cell_free.methods.empty() && !interrupted()) {
        const std::filesystem::path folder = std::filesystem::path(out) / "without-cells";
        const Results others = run_study(cell_free, folder, graphics, {.say = say, .stopped = interrupted});
        write_results(others, folder);
        simple.rows.insert(simple.rows.end(), others.rows.begin(), others.rows.end());
    }
    if (interrupted()) return stopped();
    say("drawing the charts");
    write_cells_report(curves, measure, within, out, format);
    say("");
    for (const CellsCurve& curve : curves) write_knee(curve, measure, within, out);
    if (!kinds.empty()) write_coarsest(curves, measure, within, out);
    if (reach)
        for (const Group& group : groups(simple)) {
            const Row* found = simplest(group.rows, measure, *reach);
            std::cout << one_line(group.scene, 1000) << ": "
                      << (found ? "the simplest method that reaches it is " + method_text(found->method) + ", budget " +
                                      found->budget + on_cells(*found, tables)
                                : std::string("no method that was tried reaches it"))
                      << "\n";
        }
    std::cout << "Written: " << one_line(out, 4096)
              << "/cells.html, results.json, results.csv, charts/, *.settings.json\n";
    return 0;
}

}  // namespace sightline::lab
