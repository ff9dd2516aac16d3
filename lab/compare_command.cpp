// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include "core/error.h"
#include "lab/command.h"
#include "lab/compare_report.h"
#include "lab/run_study.h"
#include "lab/say.h"
#include "lab/study_options.h"

namespace sightline::lab {

int compare_command(int argc, const char* const* argv) {
    CLI::App app{"Says what changed from A to B, and whether it is more than the noise.", "lab compare"};
    std::string a, b, out = "out/compare";
    StudyOptions options;
    app.add_option("A", a, "folder or results.json of a study, or a method")->required();
    app.add_option("B", b, "those of another study, or another method")->required();
    add_study_options(app, options);
    app.add_option("--out", out, "folder of the results")->capture_default_str();
    if (!parse(app, argc, argv)) return 0;
    if (has_results(a) != has_results(b)) throw InputError("compare: give two studies or two methods");
    LabGraphics graphics;
    Results results_a, results_b;
    std::vector<Pair> pairs;
    Side side_a{a, {}}, side_b{b, {}};
    if (has_results(a)) {
        if (!options.scenes.empty()) throw InputError("compare: two studies have their scenes already");
        results_a = load_results(a);
        results_b = load_results(b);
        side_a.study = read_study(results_a.conditions.study);
        side_b.study = read_study(results_b.conditions.study);
        pairs = compare_results(results_a, results_b);
    } else {
        options.methods = {a, b};
        const Study study = study_of(options);
        note_interrupts();
        results_a =
            run_study(study, std::filesystem::path(out) / "study", graphics, {.say = say, .stopped = interrupted});
        if (interrupted()) return stopped();
        side_a.study = side_b.study = study;
        pairs = compare_methods(results_a, parse_method(a), parse_method(b));
    }
    say("drawing the frames that changed most");
    const auto pictures = draw_side_by_side(pairs, side_a, side_b, std::filesystem::path(out) / "pictures", graphics);
    write_comparison(pairs, pictures, side_a, side_b, out);
    say("");
    for (const Pair& pair : pairs) {
        std::cout << pair.a->scene << ", " << pair.a->path << ", " << method_text(pair.a->method);
        if (!(pair.b->method == pair.a->method)) std::cout << " -> " << method_text(pair.b->method);
        std::cout << ", " << pair.a->budget << "\n";
        for (const Change& change : pair.changes)
            if (change.significant()) std::cout << "  " << change_text(change) << "\n";
    }
    for (const SideBySide& two : pictures)
        std::cout << two.title << ":\n  A: " << two.a.command << "\n  B: " << two.b.command << "\n";
    std::cout << "Written: " << out << "/compare.html, compare.json, pictures/\n";
    return 0;
}

}  // namespace sightline::lab
