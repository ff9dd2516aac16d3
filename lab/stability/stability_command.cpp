// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/base/excerpt.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "lab/command.h"
#include "lab/measure/checkpoint.h"
#include "lab/measure/out_folder.h"
#include "lab/measure/run_study.h"
#include "lab/measure/study_options.h"
#include "lab/report/chart_options.h"
#include "lab/report/remaining.h"
#include "lab/report/say.h"
#include "lab/stability/stability_report.h"

namespace sightline::lab {

namespace {

/// The rows of one scene and path; fewer where it was stopped.
template <int D>
std::vector<StabilityRow> measure(const std::string& scene, const std::string& path, const Study& spots,
                                  const StabilityOptions& options, LabGraphics& graphics, Checkpoint& checkpoint,
                                  Remaining& remaining) {
    say(excerpt(scene) + ": reading and tessellating" + remaining.text());
    const LabScene<D> lab = load_lab_scene<D>(scene, path, spots);
    const std::string key = checkpoint_key(lab) + ", ";
    StabilityWatch watch;
    watch.finished = [&](const std::string& stage) -> std::optional<std::vector<StabilityRow>> {
        const std::string* piece = checkpoint.find(key + stage);
        return piece ? std::optional(read_stability_rows(*piece)) : std::nullopt;
    };
    watch.stage_done = [&](const StabilityStage& stage) {
        if (checkpoint.find(key + stage.name)) {
            remaining.kept(stage.share);
        } else {
            checkpoint.add(key + stage.name, stability_rows_json(stage.rows));
            remaining.done(stage.share);
        }
        say(excerpt(scene) + ", path " + excerpt(lab.path) + ": " + stage.name + remaining.text());
        return !interrupted();
    };
    return measure_stability<D>(lab, spots, options, graphics.draw_ids(), watch);
}

/// The study as it is written down, with what the samples depend on.
std::string study_text(const Study& study, const StabilityOptions& options) {
    auto json = nlohmann::ordered_json::parse(study_json(study));
    json["samples"] = options.repeats;
    json["spots"] = options.frames;
    json["seed"] = options.seed;
    return json.dump();
}

}  // namespace

int stability_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Measures how much the rendered set changes under disturbances that should not matter.",
                 "lab stability"};
    StudyOptions options;
    options.budgets = {"5%"};
    add_study_options(app, options, false);
    StabilityOptions stability;
    std::string out;
    app.add_option("--samples", stability.repeats, "number of random directions, of orders and of seeds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--spots", stability.frames, "frames of the path at which the disturbances are tried")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--seed", stability.seed, "seed of the random directions and orders")->capture_default_str();
    app.add_option("--out", out, "folder of the results; default: out/stability-SCENE");
    ChartFormat format;
    add_chart_options(app, format);
    if (!parse(app, argc, argv)) return 0;
    Study study = study_of(options, tables);
    study.repeats = 0;
    const std::vector<SceneOnPath> on_paths = scenes_on_paths(study);
    check_scenes(study, say);
    LabGraphics graphics;
    const Conditions conditions =
        conditions_here(study_text(study, stability), has_3d(study) ? graphics.description() : std::string());
    if (out.empty()) out = folder_for(folder_named("stability", name_parts(study)), "stages.jsonl", conditions.study);
    std::filesystem::create_directories(out);
    Checkpoint checkpoint(std::filesystem::path(out) / "stages.jsonl", conditions);
    for (const std::string& damage : checkpoint.damages()) warn(damage);
    Study spots = study;
    spots.frames = stability.frames;
    Remaining remaining(static_cast<double>(on_paths.size()));
    note_interrupts();
    std::vector<StabilityRow> rows;
    for (const auto& [scene, path] : on_paths) {
        const auto found = parse_scene(scene).dimension == 2
                               ? measure<2>(scene, path, spots, stability, graphics, checkpoint, remaining)
                               : measure<3>(scene, path, spots, stability, graphics, checkpoint, remaining);
        if (interrupted()) return stopped();
        rows.insert(rows.end(), found.begin(), found.end());
    }
    const Results along_path = run_study(study, out, graphics, {.say = say, .stopped = interrupted});
    if (interrupted()) return stopped();
    say("drawing the charts");
    write_stability(conditions, rows, along_path, out, format);
    say("");
    for (const StabilityRow& row : rows)
        std::cout << one_line(row.scene + "  " + method_text(row.method) + " " + row.budget, 1000) << "  "
                  << disturbance_words[static_cast<std::size_t>(row.disturbance)] << " " << amount_text(row.amount)
                  << ": Jaccard " << short_number(row.jaccard, 4) << " (exact set "
                  << short_number(row.visible_jaccard, 4) << "), coverage changes by "
                  << short_number(100 * row.coverage_change) << " %" << (row.equal ? ", same order" : "")
                  << (row.not_finite > 0 ? ", NOT FINITE " + std::to_string(row.not_finite) : "") << "\n";
    std::cout << "Written: " << one_line(out, 4096) << "/stability.html, stability.json, stability.csv, charts/\n";
    return 0;
}

}  // namespace sightline::lab
