// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "core/base/error.h"
#include "core/base/quote.h"
#include "core/session/settings_table.h"
#include "lab/command.h"
#include "lab/measure/study_options.h"
#include "lab/report/chart_options.h"
#include "lab/report/say.h"
#include "lab/viewpoint/measure_viewpoint.h"
#include "lab/viewpoint/viewpoint_report.h"

namespace sightline::lab {

int viewpoint_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Measures the choice of a technique by viewpoint beside each technique alone.", "lab viewpoint"};
    ViewpointOptions options;
    ChartFormat format;
    Study study;
    std::string out, markdown, image = "1024x768";
    app.add_option("SCENES", study.scenes,
                   "3D scenes of the catalogue, with a size if you like, or files; SCENE@PATH: along that path; "
                   "default: campus");
    app.add_option("--path", study.paths.front(), "a path of the scenes, or a file; default: test");
    app.add_option("--frames", options.frames, "so many frames, spread evenly over the path; 0: all")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    app.add_option("--method", options.method, "by-viewpoint with parameters, such as its techniques")
        ->capture_default_str();
    app.add_option("--image", image, "size of images that decide and of those that are drawn")->capture_default_str();
    app.add_option("--repeats", options.repeats, "times that each frame is measured; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--fit-views", options.fit_views, "views that the cost model is fitted to")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    app.add_flag("!--no-fit", options.calibrates, "take the cost model's constants from --method, and fit none");
    app.add_flag("--fill", options.fills,
                 "work out all entries of tables with at most 10,000, not only those that the path needs");
    app.add_flag(
        "--sizes", options.sizes,
        "work out tables with more and more intervals, of scenes where one has at most 2,500 entries, and compare "
        "their sizes");
    app.add_option("--table", options.table,
                   "file of the table: entries in it are not worked out again, and it is written when all is done");
    app.add_option("--threads", options.threads, "to work out entries; 0: as many as the machine has")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_option("--out", out, "folder of the results; default: out/viewpoint-SCENE");
    app.add_option("--markdown", markdown, "also write a documentation page, FILE.md, with its charts beside it");
    add_chart_options(app, format);
    if (!parse(app, argc, argv)) return 0;
    Settings settings;
    apply_setting(settings, "reference_size=" + image);
    options.image = settings.reference_size;
    if (study.scenes.empty()) study.scenes = {"campus"};
    if (!options.table.empty() && study.scenes.size() > 1)
        throw InputError("--table: a table is of one scene, and there are " + std::to_string(study.scenes.size()));
    if (out.empty()) out = "out/viewpoint-" + file_stem(study.scenes.front());

    note_interrupts();
    LabGraphics graphics;
    ViewpointResults results{conditions_here("{}", graphics.description()), options.image, options.repeats, {}};
    for (const SceneOnPath& where : scenes_on_paths(study)) {
        auto scene = measure_viewpoint(where, options, tables, graphics);
        if (!scene) return stopped();
        results.scenes.push_back(std::move(*scene));
    }
    say("");
    write_viewpoint(results, out, format);
    if (!markdown.empty()) {
        std::string command = "./run lab";
        for (int i = 0; i < argc; ++i) command += " " + shell_quoted(argv[i]);
        write_viewpoint_page(results, command, markdown, format);
    }
    std::cout << viewpoint_text(results) << "Written: " << out << "/viewpoint.txt\n";
    return 0;
}

}  // namespace sightline::lab
