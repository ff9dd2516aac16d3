// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "core/number.h"
#include "lab/command.h"
#include "lab/lab_graphics.h"
#include "lab/measure_path.h"
#include "lab/say.h"
#include "lab/stability_report.h"
#include "lab/study_options.h"

namespace sightline::lab {

namespace {

template <int D>
void measure(const std::string& scene, const std::string& path, const Study& study, const StabilityOptions& options,
             LabGraphics& graphics, std::vector<StabilityRow>& rows, Results& along_path) {
    const LabScene<D> lab = load_lab_scene<D>(scene, path, study);
    Study few = study;  // the disturbances: first, middle and last frame
    few.frames = options.frames;
    const LabScene<D> spots = load_lab_scene<D>(scene, path, few);
    const std::vector<StabilityRow> found = measure_stability<D>(spots, few, options, graphics.draw_ids(), say);
    rows.insert(rows.end(), found.begin(), found.end());
    say(scene + ": along the path");
    Instruments instruments;
    instruments.draw_ids = graphics.draw_ids();
    Study untimed = study;
    untimed.repeats = 0;
    const std::vector<Row> measured = measure_path<D>(lab, untimed, instruments);
    along_path.rows.insert(along_path.rows.end(), measured.begin(), measured.end());
}

}  // namespace

int stability_command(int argc, const char* const* argv) {
    CLI::App app{"Measures how much what is rendered changes for what should not matter.", "lab stability"};
    StudyOptions options;
    options.budgets = {"5%"};
    options.repeats = 0;
    add_study_options(app, options);
    StabilityOptions stability;
    std::string out = "out/stability";
    app.add_option("--samples", stability.repeats, "random directions, orders and seeds of each kind")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--spots", stability.frames, "frames of the path at which the disturbances are tried")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--seed", stability.seed, "of the random directions and orders")->capture_default_str();
    app.add_option("--out", out, "folder of the results")->capture_default_str();
    if (!parse(app, argc, argv)) return 0;
    const Study study = study_of(options);
    LabGraphics graphics;
    std::vector<StabilityRow> rows;
    Results along_path;
    for (const std::string& scene : study.scenes)
        for (const std::string& path : study.paths)
            parse_scene(scene).dimension == 2 ? measure<2>(scene, path, study, stability, graphics, rows, along_path)
                                              : measure<3>(scene, path, study, stability, graphics, rows, along_path);
    say("drawing the charts");
    write_stability(conditions_here(study, graphics.description()), rows, along_path, out);
    say("");
    for (const StabilityRow& row : rows)
        std::cout << row.scene << "  " << method_text(row.method) << " " << row.budget << "  "
                  << disturbance_words[static_cast<std::size_t>(row.disturbance)] << " " << short_number(row.amount)
                  << ": Jaccard " << short_number(row.jaccard, 4) << " (exact set "
                  << short_number(row.visible_jaccard, 4) << "), coverage changes by "
                  << short_number(100 * row.coverage_change) << " %" << (row.equal ? ", same order" : "")
                  << (row.not_finite > 0 ? ", NOT FINITE " + std::to_string(row.not_finite) : "") << "\n";
    std::cout << "Written: " << out << "/stability.html, stability.json, stability.csv, charts/\n";
    return 0;
}

}  // namespace sightline::lab
