// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/study.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/methods/method_table.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/read/load.h"
#include "core/session/settings_table.h"

namespace sightline::lab {

namespace {

/// What stands behind the id of a method; nothing on Delaunay cells.
std::string suffix_of(Tessellation tessellation) {
    return tessellation == Tessellation::delaunay ? "" : "@" + std::string(word(tessellation));
}

bool is_2d_file(const std::string& name) {
    const std::string file = name.substr(0, name.find('#'));
    std::string ending = std::filesystem::path(file).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending == ".json" || ending == ".geojson" || ending == ".wad") return true;
    return ending.empty() && file.starts_with("freedoom");
}

}  // namespace

MethodChoice parse_method(std::string_view text, const MethodTables& tables) {
    VariantText variant = read_variant(text);
    MethodChoice choice;
    for (const Tessellation tessellation : {Tessellation::tree, Tessellation::kd})
        if (const std::string suffix = suffix_of(tessellation); variant.id.ends_with(suffix)) {
            variant.id.resize(variant.id.size() - suffix.size());
            choice.tessellation = tessellation;
            break;
        }
    Parameters ignored;
    try {
        variant.id = find_variant<3>(tables.in_3d, variant, ignored).id;
    } catch (const InputError&) {
        const bool in_2d = std::any_of(tables.in_2d.begin(), tables.in_2d.end(),
                                       [&](const Method<2>& method) { return method.id == variant.id; });
        if (!in_2d) throw;
        variant.id = find_variant<2>(tables.in_2d, variant, ignored).id;
    }
    choice.variant = variant.text();
    return choice;
}

std::string method_text(const MethodChoice& choice) {
    const std::string id = choice.id();
    return id + suffix_of(choice.tessellation) + choice.variant.substr(id.size());
}

std::string tessellation_word(const MethodChoice& choice) { return std::string(word(choice.tessellation)); }

Tessellation read_tessellation(std::string_view text) {
    for (std::size_t i = 0; i < words<Tessellation>.size(); ++i)
        if (words<Tessellation>[i] == text) return static_cast<Tessellation>(i);
    throw InputError("'" + excerpt(text) + "' is no tessellation: " + std::string(word_list<Tessellation>()));
}

std::vector<MethodChoice> all_methods(const MethodTables& tables) {
    std::vector<MethodChoice> choices;
    for (const Method<3>& method : tables.in_3d) {
        if (!method.compared) continue;
        choices.push_back({std::string(method.id), Tessellation::delaunay});
        if (method.orders_cells()) choices.push_back({std::string(method.id), Tessellation::tree});
    }
    return choices;
}

void add_baselines(Study& study) {
    for (const char* const id : {view_culling, exactly_v}) {
        const auto same = [&](const MethodChoice& choice) { return choice.variant == id; };
        if (std::any_of(study.methods.begin(), study.methods.end(), same)) continue;
        if (const MethodChoice choice{id}; method_of<2>(study.tables, choice) || method_of<3>(study.tables, choice))
            study.methods.push_back(choice);
    }
}

template <int D>
const Method<D>* method_of(const MethodTables& tables, const MethodChoice& choice) {
    const std::string id = choice.id();
    for (const Method<D>& method : tables.of<D>())
        if (method.id == id) return &method;
    return nullptr;
}
template const Method<2>* method_of<2>(const MethodTables&, const MethodChoice&);
template const Method<3>* method_of<3>(const MethodTables&, const MethodChoice&);

SceneName parse_scene(const std::string& text) {
    if (text.starts_with("2d:")) return {2, text.substr(3)};
    if (text.starts_with("3d:")) return {3, text.substr(3)};
    if (find_in_catalogue<3>(text)) return {3, text};
    return {find_in_catalogue<2>(text) || is_2d_file(text) ? 2 : 3, text};
}

std::vector<SceneOnPath> scenes_on_paths(const Study& study) {
    std::vector<SceneOnPath> all;
    for (const std::string& scene : study.scenes) {
        const std::size_t at = scene.rfind('@');
        std::error_code error;
        if (at != std::string::npos && !std::filesystem::exists(parse_scene(scene).name, error))
            all.push_back({scene.substr(0, at), scene.substr(at + 1)});
        else
            for (const std::string& path : study.paths) all.push_back({scene, path});
    }
    return all;
}

std::optional<PathPart> part_of_path(const std::string& name) {
    const std::size_t colon = name.rfind(':'), dash = name.rfind('-');
    if (colon == std::string::npos || dash == std::string::npos || dash < colon) return std::nullopt;
    const std::string_view text = name;
    const auto first = parse_whole(text.substr(colon + 1, dash - colon - 1)), last = parse_whole(text.substr(dash + 1));
    if (!first || !last || *last < *first) return std::nullopt;
    return PathPart{name.substr(0, colon), *first, *last};
}

bool has_3d(const Study& study) {
    const std::vector<SceneOnPath> all = scenes_on_paths(study);
    return std::any_of(all.begin(), all.end(),
                       [](const SceneOnPath& one) { return parse_scene(one.scene).dimension == 3; });
}

Study at_error_bound(const Study& study, double error_bound) {
    Study one = study;
    if (!study.error_bounds.empty()) one.settings.push_back("error_bound=" + number_text(error_bound));
    return one;
}

std::string study_json(const Study& study) {
    Settings asked;
    asked.reference_size = study.size;
    nlohmann::ordered_json json{{"scenes", study.scenes},
                                {"paths", study.paths},
                                {"frames", study.frames},
                                {"size", setting_row("reference_size").get(asked)},
                                {"settings", study.settings},
                                {"repeats", study.repeats},
                                {"error_bounds", study.error_bounds}};
    for (const MethodChoice& choice : study.methods) json["methods"].push_back(method_text(choice));
    for (const Budget& budget : study.budgets) json["budgets"].push_back(budget_text(budget));
    if (!study.wrong_budgets.empty()) json["wrong_budgets"] = study.wrong_budgets;
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Study read_study(std::string_view text, const MethodTables& tables) {
    Study study;
    study.tables = tables;
    try {
        const auto json = nlohmann::ordered_json::parse(text);
        study.scenes = json.at("scenes").get<std::vector<std::string>>();
        study.paths = json.at("paths").get<std::vector<std::string>>();
        study.frames = json.at("frames");
        study.settings = json.at("settings").get<std::vector<std::string>>();
        study.repeats = json.at("repeats");
        study.error_bounds = json.value("error_bounds", std::vector<double>());
        study.wrong_budgets = json.value("wrong_budgets", std::vector<double>());
        Settings settings;
        apply_setting(settings, "reference_size=" + json.at("size").get<std::string>());
        study.size = settings.reference_size;
        study.methods.clear();
        study.budgets.clear();
        for (const auto& method : json.at("methods"))
            study.methods.push_back(parse_method(method.get<std::string>(), tables));
        for (const auto& budget : json.at("budgets")) study.budgets.push_back(parse_budget(budget.get<std::string>()));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(std::string("not a study: ") + one_line(error.what()));
    }
    return study;
}

}  // namespace sightline::lab
