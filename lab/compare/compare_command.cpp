// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "lab/command.h"
#include "lab/compare/compare_report.h"
#include "lab/measure/run_study.h"
#include "lab/measure/study_options.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

Side side(const std::string& name, const Results& results, const MethodTables& tables) {
    return {name, read_study(results.conditions.study, tables), results.conditions};
}

}  // namespace

int compare_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Says what changed from A to B, and whether it is more than the noise.", "lab compare"};
    std::string a, b, out = "out/compare";
    StudyOptions options;
    app.add_option("A", a, "folder or results.json of a study, or a method")->required();
    app.add_option("B", b, "the same of another study, or another method")->required();
    add_study_options(app, options);
    app.add_option("--out", out, "folder of the results")->capture_default_str();
    if (!parse(app, argc, argv)) return 0;
    if (has_results(a) != has_results(b)) throw InputError("compare: give two studies or two methods");
    LabGraphics graphics;
    Results results_a, results_b;
    Comparison comparison;
    if (has_results(a)) {
        if (!options.scenes.empty()) throw InputError("compare: two studies have their scenes already");
        results_a = load_results(a);
        results_b = load_results(b);
        comparison = {side(a, results_a, tables), side(b, results_b, tables), true,
                      compare_results(results_a, results_b)};
    } else {
        options.methods = {a, b};
        note_interrupts();
        results_a = run_study(study_of(options, tables), std::filesystem::path(out) / "study", graphics,
                              {.say = say, .stopped = interrupted});
        if (interrupted()) return stopped();
        comparison = {side(a, results_a, tables), side(b, results_a, tables), false,
                      compare_methods(results_a, parse_method(a, tables), parse_method(b, tables))};
    }
    say("drawing the frames that changed most");
    std::vector<SideBySide> pictures;
    try {
        pictures = draw_side_by_side(comparison, std::filesystem::path(out) / "pictures", graphics);
    } catch (const InputError& error) {
        say("");
        std::cerr << "lab: warning: there are no pictures: " << one_line(error.what(), 1000) << "\n";
    }
    write_comparison(comparison, pictures, out);
    say("");
    for (const Pair& pair : comparison.pairs) {
        std::string heading = pair.a->scene + ", " + pair.a->path + ", " + method_text(pair.a->method);
        if (!(pair.b->method == pair.a->method)) heading += " -> " + method_text(pair.b->method);
        std::cout << one_line(heading + ", " + pair.a->budget, 1000) << "\n";
        for (const Change& change : pair.changes)
            if (change.significant()) std::cout << "  " << change_text(change) << "\n";
    }
    for (const std::string& note : notes_of(comparison)) std::cout << one_line(note, 1000) << "\n";
    for (const SideBySide& two : pictures)
        std::cout << one_line(two.title, 1000) << ":\n  A: " << two.a.command << "\n  B: " << two.b.command << "\n";
    std::cout << "Written: " << one_line(out, 4096) << "/compare.html, compare.json, pictures/\n";
    return 0;
}

}  // namespace sightline::lab
