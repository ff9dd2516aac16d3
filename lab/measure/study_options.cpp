// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/study_options.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <map>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/session/settings_file.h"
#include "core/session/settings_table.h"
#include "lab/measure/wrong_budget.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

/// The five generated scenes of the papers' kind, at a size that a study of minutes can bear.
const std::vector<std::string> default_scenes{"city", "cars", "room", "jungle", "plant"};
/// The same as the papers' claims need them.
const std::vector<std::string> scenes_of_the_papers{"city:100k@street",
                                                    "city:100k@air",
                                                    "city:500k@street",
                                                    "city:500k@air",
                                                    "city:500k@street:60-67",
                                                    "city:500k@air:60-67",
                                                    "cars@round",
                                                    "cars@round:60-67",
                                                    "room@walk",
                                                    "room@outside",
                                                    "jungle",
                                                    "plant"};
constexpr std::uint32_t frames_of_the_papers = 8;

/// What a settings file says where the command line says nothing.
void add_file(StudyOptions& o, const std::vector<std::string>& assignments) {
    Settings settings;
    bool has_method = false, has_budget = false;
    std::vector<std::string> others;
    for (const std::string& assignment : assignments) {
        apply_setting(settings, assignment);
        const bool method = assignment.starts_with("method="), budget = assignment.starts_with("budget=");
        has_method |= method;
        has_budget |= budget;
        if (!method && !budget && !assignment.starts_with("tessellation=")) others.push_back(assignment);
    }
    if (o.methods.empty() && has_method) o.methods = {method_text({settings.method, settings.tessellation})};
    if (o.budgets.empty() && has_budget) o.budgets = {budget_text(settings.budget)};
    o.settings.insert(o.settings.begin(), others.begin(), others.end());
}

}  // namespace

void add_study_options(CLI::App& app, StudyOptions& o, bool timed) {
    app.add_option(
        "SCENE", o.scenes,
        "catalogue ids, with a size if you like (city:100k), or files; 2d: or 3d: before a name that both "
        "dimensions have; @PATH puts one on a path of its own: city@air; default: city cars room jungle plant");
    app.add_option("--path", o.paths,
                   "id of a path of the scene, a file, start (the start view) or turn (one full turn on the spot); "
                   "a part of one: street:60-67; default: test, else turn; may be given several times")
        ->allow_extra_args(false);
    app.add_option("--frames", o.frames, "number of frames, spread evenly over the path; default: all")
        ->check(CLI::Range(1, 1'000'000'000));
    app.add_option("--methods,--method", o.methods,
                   "ids with commas between; @tree puts one on octree cells, @kd on those of a kd-tree: "
                   "published@tree; with parameters and "
                   "semicolons between: \"published; published on_reenqueue=min\"");
    app.add_option("--budgets,--budget", o.budgets,
                   "comma-separated, such as 1%,2%,5%,10% or 500,5000; 8ms: is a budget in time kept? wrong:0.5%: "
                   "does a budget that follows the wrong pixels of the frames before keep them there?")
        ->delimiter(',');
    app.add_option("--size", o.size, "size of the reference in pixels: such as 1024x768 in 3D, 8192 in 2D");
    app.add_option("--set", o.settings, "FIELD=VALUE as in the viewers; may be given several times")
        ->allow_extra_args(false);
    app.add_option("--settings", o.settings_file,
                   "a settings file such as lab cells writes: its method, budget and tessellation unless others are "
                   "given here, and all its other settings");
    if (timed)
        app.add_option("--repeats", o.repeats, "timed runs per frame, of which the median is taken; 0: no timing")
            ->check(CLI::Range(0, 1000));
}

namespace {

/// An assignment that would do nothing, or that another one takes back.
void check_settings(const std::vector<std::string>& assignments) {
    static constexpr std::array<std::array<std::string_view, 2>, 4> elsewhere{
        {{"method", "--methods"},
         {"budget", "--budgets"},
         {"tessellation", "METHOD@tree or METHOD@kd"},
         {"reference_size", "--size"}}};
    std::vector<std::string_view> fields;
    for (const std::string& assignment : assignments) {
        const std::string_view field = std::string_view(assignment).substr(0, assignment.find('='));
        for (const auto& [name, option] : elsewhere)
            if (field == name)
                throw InputError("--set " + excerpt(assignment) + ": in a study that is " + std::string(option));
        if (std::find(fields.begin(), fields.end(), field) != fields.end())
            throw InputError("--set " + excerpt(field) + ": is given twice");
        fields.push_back(field);
    }
}

template <typename T, typename Text>
void refuse_twice(const std::vector<T>& all, const char* option, Text text) {
    for (auto at = all.begin(); at != all.end(); ++at)
        if (std::find(all.begin(), at, *at) != at)
            throw InputError(std::string(option) + " " + excerpt(text(*at)) + ": is given twice");
}

/// Parameters that another one makes mean nothing.
void warn_of_idle_parameters(const Study& study) {
    for (const MethodChoice& choice : study.methods) {
        std::map<std::string, std::string> values;
        for (const std::string& assignment : study.settings)
            if (const std::size_t at = assignment.find('='); at != std::string::npos)
                values[assignment.substr(0, at)] = assignment.substr(at + 1);
        for (const auto& [name, value] : read_variant(choice.variant).assignments) values[name] = value;
        const Method<3>* const method = method_of<3>(study.tables, choice);
        if (!method || !method->parameter("star_shaped")) continue;
        for (const char* const idle : {"penalty", "penalty_amount"}) {
            const bool off = values["star_shaped"] == "off", none = values["penalty"] == "none";
            if (values[idle].empty() || values[idle] == "none" ||
                (!off && !(none && idle == std::string_view("penalty_amount"))))
                continue;
            warn(excerpt(method_text(choice)) + ": " + idle + "=" + excerpt(values[idle]) + " does nothing with " +
                 (off ? "star_shaped=off" : "penalty=none"));
        }
    }
}

}  // namespace

void ask_for_claims(StudyOptions& options) {
    if (!options.scenes.empty() || !options.paths.empty()) return;
    options.scenes = scenes_of_the_papers;
    if (options.frames == 0) options.frames = frames_of_the_papers;
}

Study study_of(const StudyOptions& options, const MethodTables& tables) {
    StudyOptions o = options;
    check_settings(o.settings);
    if (!o.settings_file.empty()) add_file(o, read_settings(read_file(o.settings_file), o.settings_file));
    Study study;
    study.tables = tables;
    study.methods = all_methods(tables);
    study.scenes = o.scenes.empty() ? default_scenes : o.scenes;
    if (!o.paths.empty()) study.paths = o.paths;
    study.frames = o.frames;
    study.repeats = o.repeats;
    if (!o.methods.empty()) {
        study.methods.clear();
        for (const std::string& list : o.methods)
            for (const std::string& method : split_variants(list))
                study.methods.push_back(parse_method(method, tables));
    }
    if (!o.budgets.empty()) {
        study.budgets.clear();
        for (const std::string& budget : o.budgets)
            if (const std::optional<double> wrong = parse_wrong_budget(budget))
                study.wrong_budgets.push_back(*wrong);
            else
                study.budgets.push_back(parse_budget(budget));
    }
    Settings settings;
    if (!o.size.empty()) apply_setting(settings, "reference_size=" + o.size);
    study.size = settings.reference_size;
    for (const std::string& assignment : o.settings) apply_setting(settings, assignment);
    if (settings.automatic == Switch::on)
        throw InputError("--set auto=on: a study measures the methods that it names; what is best, lab cells says");
    study.settings = o.settings;
    refuse_twice(study.methods, "--methods", method_text);
    refuse_twice(study.budgets, "--budgets", budget_text);
    refuse_twice(study.wrong_budgets, "--budgets", wrong_budget_text);
    refuse_twice(study.scenes, "SCENE", [](const std::string& name) { return name; });
    refuse_twice(study.paths, "--path", [](const std::string& name) { return name; });
    const std::vector<SceneOnPath> on_paths = scenes_on_paths(study);
    const auto asked = [&](const SceneOnPath& one) {
        return std::find(study.paths.begin(), study.paths.end(), one.path) != study.paths.end();
    };
    if (!o.paths.empty() && std::none_of(on_paths.begin(), on_paths.end(), asked))
        throw InputError("--path " + excerpt(o.paths.front()) + ": each scene has a path of its own, behind its @");
    warn_of_idle_parameters(study);
    return study;
}

bool parse(CLI::App& app, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return false;
    } catch (const CLI::ParseError& error) {
        throw InputError(one_line(error.what()) + " (--help lists the options)");
    }
    for (const CLI::Option* const option : app.get_options())
        for (const std::string& value : option->results())
            if (value.empty()) throw InputError(option->get_name() + ": is empty; leave it out, or say what it is");
    return true;
}

}  // namespace sightline::lab
