// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/quote.h"
#include "core/base/text.h"
#include "core/methods/coorg_teller/visible_run.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/session/settings_table.h"
#include "core/truth/software_ids.h"
#include "lab/command.h"
#include "lab/lab_graphics.h"
#include "lab/measure/study_options.h"
#include "lab/object_space/object_space_report.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

/// Scenes of the catalogue with seeds that follow one another; a file has one.
std::vector<SeededScene> seeded_scenes(const std::string& name, std::uint64_t seeds) {
    std::vector<SeededScene> all;
    const CatalogueRow<3>* const row = find_in_catalogue<3>(name.substr(0, name.find(':')));
    if (!row) {
        auto scene = std::make_shared<const Scene<3>>(load_scene<3>(name));
        return {{name, scene->seed, scene}};
    }
    for (std::uint64_t i = 0; i < seeds; ++i)
        all.push_back({name, row->seed + i, std::make_shared<const Scene<3>>(*generated_scene(name, row->seed + i))});
    return all;
}

void check_methods(const std::vector<std::string>& methods, const MethodTables& tables) {
    for (const std::string& text : methods) {
        const Variant<3> variant = make_variant<3>(tables.in_3d, text);
        if (variant.method.id != "coorg-teller" && variant.method.id != "shadow-frusta")
            throw InputError("--methods: '" + variant.text +
                             "' does not cull in object space; coorg-teller and shadow-frusta do");
    }
}

std::string study_text(const ObjectSpaceOptions& options, const std::vector<std::string>& scenes,
                       const std::vector<std::string>& methods, std::uint64_t seeds) {
    return nlohmann::ordered_json{{"scenes", scenes},
                                  {"methods", methods},
                                  {"seeds", seeds},
                                  {"walk", options.walk},
                                  {"line", options.line},
                                  {"frames", options.frames},
                                  {"repeats", options.repeats},
                                  {"face", image_size_text(options.face)},
                                  {"image", image_size_text(options.image)},
                                  {"parallel", options.parallel},
                                  {"workers", options.workers}}
        .dump();
}

bool has_path(const SeededScene& scene, const std::string& id) {
    for (const FlightPath<3>& path : scene.scene->paths)
        if (path.id == id) return true;
    return false;
}

}  // namespace

int object_space_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Measures culling by occluders plane by plane, beside the tables of Coorg and Teller (1996).",
                 "lab object-space"};
    std::vector<std::string> scenes, methods, large;
    std::string out = "out/object-space", markdown_file, face;
    ObjectSpaceOptions options;
    options.tables = tables;
    options.frames = 48;
    std::uint64_t seeds = 3;
    app.add_option("SCENE", scenes,
                   "3D scenes of the catalogue, with a size if you like, or files; default: soda blocks tetra");
    app.add_option("--methods", methods,
                   "variants of coorg-teller and shadow-frusta with semicolons between; default: single and connected "
                   "occluders, those grown, those that polygons of leaves are tested against, and shadow frusta");
    app.add_option("--seeds", seeds, "seeds of each generated scene over which culling is averaged")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    app.add_option("--walk", options.walk, "path of all but the table of speeds")->capture_default_str();
    app.add_option("--line", options.line, "path of the table of speeds")->capture_default_str();
    app.add_option("--frames", options.frames,
                   "frames, spread evenly over the walk, that are held against the exact set and drawn; 0: all")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    app.add_option("--repeats", options.repeats, "passes over a path, of which each frame's median is taken")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--face", face, "size of each of the six item buffers; default: 512x512");
    app.add_option("--large", large,
                   "scenes for the table of threads alone, in which a frame takes longer; default: city:1M; none: "
                   "leaves it out")
        ->delimiter(',');
    app.add_option("--workers", options.workers, "numbers of threads, the first to compare with")
        ->delimiter(',')
        ->check(CLI::Range(1, 64));
    app.add_option("--out", out, "folder of the results")->capture_default_str();
    app.add_option("--markdown", markdown_file, "also write a documentation page, FILE.md");
    if (!parse(app, argc, argv)) return 0;
    if (scenes.empty()) scenes = {"soda", "blocks", "tetra"};
    if (large.empty()) large = {"city:1M"};
    if (large.front() == "none") large.clear();
    if (!face.empty()) {
        Settings settings;
        apply_setting(settings, "reference_size=" + face);
        options.face = settings.reference_size;
    }
    std::vector<std::string> variants;
    for (const std::string& list : methods)
        for (const std::string& one : split_variants(list)) variants.push_back(make_variant<3>(tables.in_3d, one).text);
    if (variants.empty())
        variants = {"coorg-teller",
                    "coorg-teller connected=on",
                    "coorg-teller connected=grow",
                    "coorg-teller connected=on leaves=polygons",
                    "coorg-teller connected=on leaves=polygons tree=octree",
                    "shadow-frusta"};
    check_methods(variants, tables);
    std::vector<std::string> against_view{std::string(view_culling)};
    against_view.insert(against_view.end(), variants.begin(), variants.end());

    LabGraphics graphics;
    ObjectSpaceResults results;
    results.options = options;
    const bool draws = graphics.has_opengl();
    results.conditions =
        conditions_here(study_text(options, scenes, variants, seeds), draws ? graphics.description() : std::string());
    note_interrupts();
    for (const std::string& name : scenes) {
        ObjectSpaceScene& row = results.scenes.emplace_back();
        row.name = name;
        const std::vector<SeededScene> all = seeded_scenes(name, seeds);
        const SeededScene& first = all.front();
        say(name + ": building");
        for (const char* const tree : {"kd", "octree"})
            row.construction.push_back(measure_construction(first, tree, options));
        for (const SeededScene& scene : all) {
            say(name + ": seed " + std::to_string(scene.seed) + ", seen all round");
            row.seeds.push_back(scene.seed);
            row.all_round.push_back(measure_all_round(scene, variants, &draw_ids_in_software, options));
            if (interrupted()) return 1;
        }
        say(name + ": speeds");
        if (has_path(first, options.line)) row.speeds = measure_speeds(first, "coorg-teller connected=on", options);
        say(name + ": threads");
        row.workers = measure_workers(first, options);
        say(name + ": in a view");
        row.in_view =
            measure_in_view(first, against_view, draws ? graphics.time_drawing(options.image) : TimeDrawing{}, options);
        if (interrupted()) return 1;
    }
    for (const std::string& name : large) {
        say(name + ": threads");
        SeededScene scene = seeded_scenes(name, 1).front();
        ObjectSpaceOptions of_large = options;
        if (!has_path(scene, of_large.walk)) of_large.walk.clear();
        ObjectSpaceScene& row = results.scenes.emplace_back();
        row.name = name;
        row.workers = measure_workers(scene, of_large);
        if (interrupted()) return 1;
    }
    say("");
    write_object_space(results, out);
    if (!markdown_file.empty()) {
        std::string command = "./run lab";
        for (int i = 0; i < argc; ++i) command += " " + shell_quoted(argv[i]);
        write_file(markdown_file, object_space_markdown(results, command));
    }
    for (const TitledTable& table : object_space_tables(results)) std::cout << plain_text(table) << "\n";
    for (const Claim& claim : object_space_claims(results)) {
        std::cout << verdict_text(claim) << ": " << claim.text << " (" << claim.source << ")\n";
        for (const Regime& regime : claim.regimes) std::cout << "  " << one_line(regime_text(claim, regime)) << "\n";
    }
    std::cout << "Written: " << one_line(out, 4096) << "/object-space.html, results.json\n";
    return 0;
}

}  // namespace sightline::lab
