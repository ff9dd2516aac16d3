// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/methods/by_viewpoint/by_viewpoint.h"
#include "core/methods/by_viewpoint/table_file.h"
#include "core/scene/read/load.h"
#include "core/scene/scene_view.h"
#include "core/session/settings_table.h"
#include "core/space/builders.h"
#include "lab/command.h"
#include "lab/lab_graphics.h"
#include "lab/measure/lab_scene.h"
#include "lab/measure/study_options.h"
#include "lab/report/chart_options.h"
#include "lab/report/say.h"
#include "lab/viewpoint/viewpoint_report.h"

namespace sightline::lab {

namespace {

struct ViewpointOptions {
    std::string scene = "campus", path, method = std::string(by_viewpoint_id), table, out, image = "1024x768";
    std::size_t frames = 0, fit_views = 24;
    int repeats = 3, threads = 0;
    bool calibrates = true, fills = false;
};

/// Views for the cost model: some of the path, and as many of entries from all over the table.
std::vector<View<3>> views_to_fit(const std::vector<View<3>>& of_path, const ViewpointTable<3>& table,
                                  std::size_t count) {
    std::vector<View<3>> views;
    for (const std::size_t frame : spread_frames(of_path.size(), (count + 1) / 2)) views.push_back(of_path[frame]);
    const Analyst<3> analyst(table.problem());
    for (const std::size_t place : spread_frames(table.size(), count / 2))
        views.push_back(scene_view(analyst.views(table.region_of(place), table.interval_of(place)).front(),
                                   *table.problem().scene, table.problem().image));
    return views;
}

/// Empty where no technique asks for cells.
CellComplex<3> cells_for(const Scene<3>& scene, const Variant<3>& by_viewpoint, const MethodTables& tables,
                         const Settings& settings) {
    for (const std::string& text : split_variants(by_viewpoint.parameters.text(techniques_row())))
        if (make_variant<3>(tables.in_3d, text).method.needs.cells) return build_cells(scene, settings);
    return {};
}

}  // namespace

int viewpoint_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Measures the choice of a technique by viewpoint beside each technique alone.", "lab viewpoint"};
    ViewpointOptions options;
    ChartFormat format;
    app.add_option("SCENE", options.scene, "a 3D scene of the catalogue, with a size if you like, or a file")
        ->capture_default_str();
    app.add_option("--path", options.path, "a path of the scene, or a file; default: test");
    app.add_option("--frames", options.frames, "so many frames, spread evenly over the path; 0: all")
        ->capture_default_str();
    app.add_option("--method", options.method, "by-viewpoint with parameters, such as its techniques")
        ->capture_default_str();
    app.add_option("--image", options.image, "size of images that decide and of those that are drawn")
        ->capture_default_str();
    app.add_option("--repeats", options.repeats, "times that each frame is measured; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--fit-views", options.fit_views, "views that the cost model is fitted to")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    app.add_flag("!--no-fit", options.calibrates, "take the cost model's constants from --method, and fit none");
    app.add_flag("--fill", options.fills, "work out all entries of the table, not only those that the path needs");
    app.add_option("--table", options.table,
                   "file of the table: entries in it are not worked out again, and it is written when all is done");
    app.add_option("--threads", options.threads, "to work out entries; 0: as many as the machine has")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_option("--out", options.out, "folder of the results; default: out/viewpoint-SCENE");
    add_chart_options(app, format);
    if (!parse(app, argc, argv)) return 0;
    Settings settings;
    apply_setting(settings, "reference_size=" + options.image);
    if (options.out.empty()) options.out = "out/viewpoint-" + file_stem(options.scene);

    note_interrupts();
    say("reading " + options.scene);
    const auto scene = std::make_shared<const Scene<3>>(load_scene<3>(options.scene));
    const FlightPath<3> path = find_path(*scene, options.path);
    ViewpointResults results;
    results.scene = options.scene;
    results.path = path.id;
    std::vector<View<3>> views;
    for (const std::size_t frame :
         spread_frames(path.frames.size(), options.frames ? options.frames : path.frames.size())) {
        results.frames.push_back(static_cast<std::uint32_t>(frame));
        views.push_back(scene_view(path.frames[frame], *scene, settings.reference_size));
    }
    Variant<3> variant = make_variant<3>(tables.in_3d, options.method);
    if (variant.method.id != by_viewpoint_id) throw InputError("--method: '" + variant.text + "' is not by-viewpoint");
    const CellComplex<3> cells = cells_for(*scene, variant, tables, settings);
    Services services;
    services.image = settings.reference_size;
    const auto table_of = [&](const Parameters& parameters) {
        if (variant.method.needs.boxes) cells.boxes->of(*scene);
        const Problem<3> problem{scene.get(), &cells, views.front(), none, parameters, nullptr, services};
        return viewpoint_table<3>(tables.in_3d, problem);
    };
    LabGraphics graphics;
    const TimeDrawing time_drawing = graphics.time_drawing(settings.reference_size);
    auto table = table_of(variant.parameters);
    results.scene_bytes = scene->primitives.size() * sizeof(Primitive<3>);
    if (options.calibrates) {
        const auto fit_views = views_to_fit(views, *table, options.fit_views);
        const auto samples =
            cost_samples(table->problem(), fit_views, scene, time_drawing, options.repeats, [&](std::size_t done) {
                say("fitting: view " + std::to_string(done) + " of " + std::to_string(fit_views.size()));
                return !interrupted();
            });
        if (interrupted()) return stopped();
        for (const CostReading reading : {CostReading::max_of_sums, CostReading::sum_of_max})
            results.fits.push_back(fit(samples, table->problem().options.size(), reading));
        const Calibration& best = results.best_fit();
        variant = make_variant<3>(tables.in_3d, variant.text + " " + parameters_text(best, table->problem().options));
    }
    if (!options.table.empty() && std::filesystem::exists(options.table))
        variant.parameters.set(table_file_row(), options.table);
    table = table_of(variant.parameters);
    results.method = variant.text;
    results.fill.known_before = table->known();
    if (options.fills) {
        const Stopwatch clock;
        table->fill(options.threads, [&](std::size_t known) {
            if (known % 16 == 0) say("entry " + std::to_string(known) + " of " + std::to_string(table->size()));
            return !interrupted();
        });
        results.fill.seconds = clock.milliseconds() / 1000;
        results.fill.merged = merged_size(*table);
    }
    if (!options.table.empty()) {
        write_table(*table, options.table);
        results.fill.file_bytes = std::filesystem::file_size(options.table);
    }
    if (interrupted()) return stopped();
    results.walk = walk_by_viewpoint(variant.method, variant.parameters, *table, scene, cells, views, time_drawing,
                                     options.repeats, [&](std::size_t done) {
                                         say("frame " + std::to_string(done) + " of " + std::to_string(views.size()));
                                         return !interrupted();
                                     });
    if (interrupted()) return stopped();
    say("");
    results.table = table;
    results.conditions = conditions_here("{}", graphics.description());
    write_viewpoint(results, options.out, format);
    std::cout << viewpoint_text(results) << "Written: " << options.out << "/viewpoint.csv, frames.svg\n";
    return 0;
}

}  // namespace sightline::lab
