// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/scene/read/load.h"
#include "core/session/condition.h"
#include "core/session/state_file.h"
#include "lab/command.h"
#include "lab/lab_graphics.h"
#include "lab/measure/out_folder.h"
#include "lab/measure/study_options.h"
#include "lab/reduce/reduce.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;

/// As Wavefront OBJ, in the file's coordinates.
std::string obj_text(const Scene<3>& scene) {
    std::string text = "# reduced from " + scene.id + "\n";
    for (const Primitive<3>& triangle : scene.primitives)
        for (const Vec<3>& p : triangle) {
            const Vec<3> q = p + scene.origin;
            text += "v " + number_text(q.x) + " " + number_text(q.y) + " " + number_text(q.z) + "\n";
        }
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        text +=
            "f " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + " " + std::to_string(3 * i + 3) + "\n";
    return text;
}

/// The scene as the viewer will read it: 2D travels inside the state file, 3D as a file beside it.
std::shared_ptr<const Scene<2>> written(const Scene<2>& scene, const fs::path&) {
    return std::make_shared<const Scene<2>>(scene);
}
std::shared_ptr<const Scene<3>> written(const Scene<3>& scene, const fs::path& folder) {
    const fs::path file = folder / "reduced.obj";
    write_file(file, obj_text(scene));
    const bool two_sided = !scene.two_sided.empty() && scene.two_sided.front();
    auto read = std::make_shared<Scene<3>>(load_scene<3>(
        file.string(), {.two_sided = two_sided, .up = static_cast<Up>(static_cast<int>(Up::x) + scene.up_axis)}));
    read->name = file.filename().string();  // the state file finds it beside itself, wherever the folder is
    return read;
}

template <int D>
int run(const Study& study, const SceneOnPath& where, const Wanted& wanted, double limit, const fs::path& folder,
        LabGraphics& graphics) {
    const LabScene<D> lab = load_lab_scene<D>(where.scene, where.path, study);
    const MethodChoice method = study.methods.front();
    const DrawIds draw_ids = graphics.draw_ids();
    const auto count = static_cast<std::uint32_t>(lab.scene->primitives.size());
    // A share would shrink with the scene.
    Budget budget = study.budgets.front();
    if (budget.kind == Budget::Kind::share) budget = {Budget::Kind::primitives, double(budget.primitives(count))};
    note_interrupts();
    const Holds holds = holds_in<D>(lab, method, budget, wanted, draw_ids);
    const Stopwatch stopwatch;
    bool out_of_time = false;
    std::size_t probes = 0, least = count + std::size_t{1};
    double said = 0;
    const std::vector<std::uint32_t> kept = reduce(count, holds, [&](const ReduceProgress& at) {
        const double seconds = stopwatch.milliseconds() / 1000;
        probes = at.probes;
        out_of_time = limit > 0 && seconds >= limit;
        const bool first = at.probes == 1, smaller = at.left < least;
        if (first || smaller || seconds > said + 2) {
            const double each = seconds / static_cast<double>(at.probes);
            say(std::to_string(at.left) + " of " + std::to_string(count) + " primitives left after " +
                counted(at.probes, "probe") + " of " + short_number(1000 * each) + " ms" +
                (first ? ""
                       : "; at most " + duration_text(each * static_cast<double>(at.most)) +
                             " more unless it gets smaller"));
            said = seconds;
            least = at.left;
        }
        return !interrupted() && !out_of_time;
    });
    const double seconds = stopwatch.milliseconds() / 1000;
    say("");
    fs::create_directories(folder);
    const Scene<D> small = subset(*lab.scene, kept);
    const auto scene = written(small, folder);
    ViewSpec<D> view = lab.specs.back();
    const Vec<D> shift = small.origin - scene->origin;
    view.eye += shift;
    view.look_at += shift;
    Settings settings = lab.settings_for(method);
    settings.budget = budget;
    Session<D> session(scene, view, settings, lab.tables.template of<D>(), draw_ids);
    bool still = true;
    if (wanted.condition.empty())
        session.run();
    else
        still = run_until(session, condition_for(session, wanted.condition)) == Stop::breakpoint;
    write_file(folder / "reduced.json", state_json<D>(session));
    std::cout << kept.size() << " of " << count << " primitives after " << counted(probes, "probe") << " in "
              << duration_text(seconds)
              << (interrupted() ? "; interrupted, so it may not be the fewest"
                  : out_of_time ? "; stopped by --limit, so it may not be the fewest"
                                : "")
              << "\n";
    if (!still)
        std::cerr << "lab: warning: read back from " << (folder / "reduced.obj").string()
                  << " the condition no longer holds: coordinates were rounded\n";
    std::cout << "See it: ./run viewer" << D << "d --state " << shell_quoted((folder / "reduced.json").string())
              << "\n";
    return interrupted() ? 1 : 0;
}

}  // namespace

int reduce_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Shrinks a scene to the fewest primitives for which an expression still holds.", "lab reduce"};
    StudyOptions options;
    options.budgets = {"10%"};
    options.methods = {"published"};
    options.paths = {"start"};
    add_study_options(app, options, false);
    Wanted wanted;
    std::string out;
    double limit = 0;
    app.add_option("--until", wanted.condition,
                   "condition that must hold after some step of the run, such as inversion == 1 && hidden_now > 2");
    app.add_option("--holds", wanted.measures,
                   "condition on measures that must hold in the last frame, such as coverage < 0.5 or pop > 0.2");
    app.add_option("--limit", limit, "seconds after which the smallest scene so far is taken; default: no limit")
        ->check(CLI::PositiveNumber);
    app.add_option("--out", out, "folder of the reduced scene; default: out/reduce-SCENE");
    if (!parse(app, argc, argv)) return 0;
    const Study study = study_of(options, tables);
    const std::vector<SceneOnPath> on_paths = scenes_on_paths(study);
    if (options.scenes.size() != 1 || study.methods.size() != 1 || study.budgets.size() != 1 || on_paths.size() != 1)
        throw InputError("reduce: one scene, one method, one budget and one path");
    if (out.empty()) out = folder_named("reduce", name_parts(study));
    LabGraphics graphics;
    const SceneOnPath& where = on_paths.front();
    return parse_scene(where.scene).dimension == 2 ? run<2>(study, where, wanted, limit, out, graphics)
                                                   : run<3>(study, where, wanted, limit, out, graphics);
}

}  // namespace sightline::lab
