// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "lab/command.h"
#include "lab/compare/compare_report.h"
#include "lab/compare/fail_if.h"
#include "lab/measure/out_folder.h"
#include "lab/measure/run_study.h"
#include "lab/measure/study_options.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

Side side(const std::string& name, const Results& results, const MethodTables& tables) {
    return {name, read_study(results.conditions.study, tables), results.conditions};
}

/// A name that looks like a file's and is none is no method either.
void check_side(const std::string& name) {
    if (has_results(name)) return;
    if (std::filesystem::is_directory(name)) throw InputError(name + ": holds no results.json of a study");
    const bool is_variant = name.find(' ') != name.npos;  // "listed file=sets.json"
    if (!is_variant && (name.ends_with(".json") || name.ends_with('/'))) throw InputError(name + ": no such file");
}

/// The study's folder.
std::string name_of_results(const std::string& name) {
    const std::filesystem::path path = std::filesystem::absolute(name).lexically_normal();
    const bool file = std::filesystem::is_regular_file(path);
    return (file || path.filename().empty() ? path.parent_path() : path).filename().string();
}

/// Whether one of the conditions holds; says which, and where.
bool say_failures(const std::vector<FailIf>& conditions, const std::vector<Pair>& pairs) {
    bool failed = false;
    for (const FailIf& condition : conditions) {
        const std::vector<std::string> lines = failures(condition, pairs);
        std::cout << (lines.empty() ? "Kept" : "Failed") << ": " << one_line(condition.text) << " (" << lines.size()
                  << " of " << counted(pairs.size(), "comparison") << ")\n";
        for (const std::string& line : lines) std::cout << "  " << one_line(line, 1000) << "\n";
        failed |= !lines.empty();
    }
    return failed;
}

}  // namespace

int compare_command(int argc, const char* const* argv, const MethodTables& tables) {
    CLI::App app{"Says what changed from A to B, and whether it is more than the noise.", "lab compare"};
    std::string a, b, out;
    std::vector<std::string> conditions;
    StudyOptions options;
    app.add_option("A", a, "folder or results.json of a study, or a method")->required();
    app.add_option("B", b, "the same of another study, or another method")->required();
    add_study_options(app, options);
    app.add_option("--out", out, "folder of the results; default: out/compare-A-B-SCENE");
    app.add_option(
           "--fail-if", conditions,
           "exit status 1 where B is worse than A by more: \"wrong worse than 0.5 %\", \"time worse than 5 %\"; "
           "may be given several times")
        ->allow_extra_args(false);
    if (!parse(app, argc, argv)) return 0;
    std::vector<FailIf> fail_if;
    for (const std::string& condition : conditions) fail_if.push_back(parse_fail_if(condition));
    for (const std::string& name : {a, b}) check_side(name);
    if (has_results(a) != has_results(b)) throw InputError("compare: give two studies or two methods");
    LabGraphics graphics;
    Results results_a, results_b;
    Comparison comparison;
    if (has_results(a)) {
        if (!options.scenes.empty()) throw InputError("compare: two studies have their scenes already");
        for (const CLI::Option* const option : app.get_options())
            if (option->count() > 0 && option->get_name().starts_with("--") && option->get_name() != "--out" &&
                option->get_name() != "--fail-if")
                throw InputError("compare: two studies are measured already; " + option->get_name() + " does nothing");
        results_a = load_results(a);
        results_b = load_results(b);
        if (out.empty()) out = folder_named("compare", {name_of_results(a), name_of_results(b)});
        comparison = {side(a, results_a, tables), side(b, results_b, tables), true,
                      compare_results(results_a, results_b)};
    } else {
        if (!options.methods.empty()) throw InputError("compare: the methods are A and B; --methods does nothing");
        options.methods = {a, b};
        note_interrupts();
        const Study study = study_of(options, tables);
        if (out.empty()) {
            std::vector<std::string> parts = name_parts(study);
            parts.insert(parts.begin(), {a, b});
            out = folder_for(folder_named("compare", parts), "study/frames.jsonl", study_json(study));
        }
        results_a =
            run_study(study, std::filesystem::path(out) / "study", graphics, {.say = say, .stopped = interrupted});
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
    return say_failures(fail_if, comparison.pairs) ? 1 : 0;
}

}  // namespace sightline::lab
