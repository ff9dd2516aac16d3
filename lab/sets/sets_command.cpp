// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "lab/command.h"
#include "lab/lab_graphics.h"
#include "lab/measure/out_folder.h"
#include "lab/measure/study_options.h"
#include "lab/report/page.h"
#include "lab/report/say.h"
#include "lab/sets/sets.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;

template <int D>
int run(const Study& study, const SceneOnPath& where, const fs::path& folder, LabGraphics& graphics) {
    const LabScene<D> lab = load_lab_scene<D>(where.scene, where.path, study);
    if (!method_of<D>(study.tables, study.methods.front()))
        throw InputError("sets: there is no method " + method_text(study.methods.front()) + " in " + std::to_string(D) +
                         "D");
    note_interrupts();
    const PathSets sets =
        path_sets<D>(lab, study.methods.front(), study.budgets.front(), D == 3 ? graphics.draw_ids() : DrawIds(),
                     [&](std::size_t done) {
                         say("frame " + std::to_string(done) + " of " + std::to_string(lab.views.size()));
                         return !interrupted();
                     });
    say("");
    fs::create_directories(folder);
    write_file(folder / "sets.json", sets_json<D>(sets, lab));
    write_file(folder / "primitives.csv", primitives_csv(sets));
    write_file(folder / "objects.csv", objects_csv(sets));
    double visible = 0, missed = 0, rendered = 0, wrong = 0, pixels = 0;
    for (const FrameSets& frame : sets.frames) {
        pixels += static_cast<double>(frame.image_pixels);
        for (const SetEntry& e : frame.entries) {
            visible += e.visible;
            rendered += e.rendered;
            missed += e.missed();
            wrong += e.wrong();
        }
    }
    const auto frames = static_cast<double>(sets.frames.size());
    std::cout << counted(sets.frames.size(), "frame") << ", " << one_line(sets.method + " at " + sets.budget)
              << ": on average " << number(visible / frames) << " visible, " << number(rendered / frames)
              << " rendered, " << number(missed / frames) << " missed; " << per_cent(pixels > 0 ? wrong / pixels : 0)
              << " % of the pixels wrong\n"
              << "Written: " << one_line(folder.string(), 4096) << "/sets.json, primitives.csv, objects.csv\n";
    return interrupted() ? 1 : 0;
}

}  // namespace

int sets_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Writes what a method renders, misses and could leave out, frame by frame, for other programs.",
                 "lab sets"};
    StudyOptions options;
    options.budgets = {"10%"};
    options.methods = {"published"};
    add_study_options(app, options, false);
    std::string out;
    app.add_option("--out", out, "folder of the files; default: out/sets-SCENE-METHOD");
    if (!parse(app, argc, argv)) return 0;
    const Study study = study_of(options, tables);
    const std::vector<SceneOnPath> on_paths = scenes_on_paths(study);
    if (options.scenes.size() != 1 || study.methods.size() != 1 || study.budgets.size() != 1 || on_paths.size() != 1)
        throw InputError("sets: one scene, one method, one budget and one path");
    if (study.budgets.front().kind == Budget::Kind::milliseconds)
        throw InputError("sets: a budget in time renders something else each time; give a share or a number");
    if (out.empty()) {
        std::vector<std::string> parts = name_parts(study);
        parts.push_back(method_text(study.methods.front()));
        out = folder_named("sets", parts);
    }
    LabGraphics graphics;
    const SceneOnPath& where = on_paths.front();
    return parse_scene(where.scene).dimension == 2 ? run<2>(study, where, out, graphics)
                                                   : run<3>(study, where, out, graphics);
}

}  // namespace sightline::lab
