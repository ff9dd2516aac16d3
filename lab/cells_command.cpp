// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "core/error.h"
#include "core/file.h"
#include "core/number.h"
#include "lab/cells_report.h"
#include "lab/chart.h"
#include "lab/command.h"
#include "lab/run_study.h"
#include "lab/say.h"
#include "lab/study_charts.h"
#include "lab/study_options.h"

namespace sightline::lab {

namespace {

Measure measure_named(const std::string& id) {
    for (const MeasureRow& row : measure_table())
        if (row.id == id && row.better != Better::neither) return row.measure;
    throw InputError("--measure '" + id + "': not a measure that can be better or worse, such as wrong or coverage");
}

/// Writes the settings of a knee and says so.
void write_knee(const CellsCurve& curve, Measure measure, double within, const std::filesystem::path& folder) {
    const std::size_t at = knee(curve, measure, within);
    const CellsPoint& point = curve.points[at];
    const std::filesystem::path file =
        folder / (file_stem(curve.scene + "-" + method_text(curve.method) + "-" + curve.budget) + ".settings.json");
    write_file(file, knee_settings(curve, measure, within));
    std::cout << curve.scene << ", " << method_text(curve.method) << " " << curve.budget << ": error bound "
              << short_number(point.error_bound) << ", " << knee_text(curve, at) << ", " << measure_row(measure).title
              << " " << short_number(summary(point.row, measure)) << "; --settings " << file.string() << "\n";
}

}  // namespace

int cells_command(int argc, const char* const* argv) {
    CLI::App app{
        "Sweeps the size of the cells and names the coarsest tessellation, and the simplest method, that will do.",
        "lab cells"};
    StudyOptions options;
    options.budgets = {"5%"};
    options.methods = {"published", "layers"};
    add_study_options(app, options);
    std::vector<double> bounds = default_error_bounds();
    std::string measure_id = "wrong", out = "out/cells";
    double within = 0.01;
    std::optional<double> reach;
    app.add_option("--error-bounds", bounds, "with commas between, each in (0, 1]")
        ->delimiter(',')
        ->check(CLI::Range(1e-3, 1.0));
    app.add_option("--measure", measure_id, "what is looked at, such as wrong, coverage or total_ms")
        ->capture_default_str();
    app.add_option("--within", within, "how much worse than the best the knee may be; a share is of 1")
        ->capture_default_str();
    app.add_option("--reach", reach, "also name the simplest method that reaches this value of the measure");
    app.add_option("--out", out, "folder of the results")->capture_default_str();
    if (!parse(app, argc, argv)) return 0;
    const Measure measure = measure_named(measure_id);
    const Study study = sweep_study(study_of(options), bounds);
    if (study.methods.empty()) throw InputError("lab cells: none of these methods orders cells");
    LabGraphics graphics;
    note_interrupts();
    const Results results = run_study(study, out, graphics, {.say = say, .stopped = interrupted});
    if (interrupted()) return stopped();
    const std::vector<CellsCurve> curves = curves_of(results);
    write_results(results, out);
    say("drawing the charts");
    write_cells_report(curves, measure, within, out);
    say("");
    for (const CellsCurve& curve : curves) write_knee(curve, measure, within, out);
    if (reach)
        for (const Group& group : groups(results)) {
            const Row* found = simplest(group.rows, measure, *reach);
            std::cout << group.scene << ": "
                      << (found ? "the simplest that reaches it is " + method_text(found->method) + " " +
                                      found->budget + " with " + std::to_string(found->cells) + " cells"
                                : std::string("nothing that was tried reaches it"))
                      << "\n";
        }
    std::cout << "Written: " << out << "/cells.html, results.json, results.csv, charts/, *.settings.json\n";
    return 0;
}

}  // namespace sightline::lab
