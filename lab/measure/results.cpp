// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/base/text.h"
#include "core/measure/distance.h"
#include "core/measure/summary.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

Json or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string extreme_id(const MeasureRow& m) {
    return std::string(m.id) + (m.better == Better::higher ? "_min" : "_max");
}

Json budget_share(const Row& row) {
    if (row.primitives == 0 || row.values.empty()) return nullptr;
    return row.values.front()[Measure::budget] / row.primitives;
}

Json to_json(const Stabbing& s) { return {{"mean", or_null(s.mean)}, {"most", s.most}, {"lines", s.lines}}; }

Json to_json(const CellNumbers& t) {
    return {{"seconds", or_null(t.seconds)},
            {"cell_bytes", t.cell_bytes},
            {"reference_bytes", t.reference_bytes},
            {"scene_bytes", t.scene_bytes},
            {"references", t.references},
            {"stabbing", to_json(t.lines)},
            {"eye_rays", to_json(t.eye_rays)},
            {"density",
             {{"empty", or_null(t.density.empty)},
              {"mean", or_null(t.density.mean)},
              {"deviation", or_null(t.density.deviation)},
              {"median", or_null(t.density.median)},
              {"histogram", t.density.histogram}}}};
}

/// Arrays by distance, as results name them.
constexpr std::array<std::pair<const char*, DistanceBins Values::*>, 2> by_distance{
    {{"wrong_at", &Values::wrong_at}, {"pixels_at", &Values::pixels_at}}};

Json to_json(const DistanceBins& bins) {
    Json json = Json::array();
    for (const double value : bins) json.push_back(or_null(value));
    return json;
}

Json distance_ends() {
    Json ends = Json::array();
    for (std::size_t bin = 0; bin < distance_bins; ++bin) ends.push_back(or_null(distance_bin_end(bin)));
    return ends;
}

double number_or_nan(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Stabbing read_stabbing(const Json& json) { return {number_or_nan(json.at("mean")), json.at("most"), json.at("lines")}; }

CellNumbers read_cell_numbers(const Json& json) {
    const Json& density = json.at("density");
    return {
        number_or_nan(json.at("seconds")),
        json.at("cell_bytes"),
        json.at("reference_bytes"),
        json.at("scene_bytes"),
        json.at("references"),
        read_stabbing(json.at("stabbing")),
        read_stabbing(json.at("eye_rays")),
        {number_or_nan(density.at("empty")), number_or_nan(density.at("mean")), number_or_nan(density.at("deviation")),
         number_or_nan(density.at("median")), density.at("histogram").get<std::vector<std::uint32_t>>()}};
}

Json to_json(const Row& row) {
    Json json{{"scene", row.scene},
              {"path", row.path},
              {"frames", row.frames.size()},
              {"method", row.method.variant},
              {"tessellation", tessellation_word(row.method)},
              {"approximate", row.approximate},
              {"primitives", row.primitives},
              {"error_bound", row.error_bound},
              {"cells", row.cells},
              {"memory_bytes", row.memory_bytes},
              {"cell_numbers", to_json(row.tessellation)},
              {"reference", row.reference},
              {"budget_text", row.budget},
              {"budget_share", budget_share(row)}};
    for (const MeasureRow& m : measure_table()) {
        json[std::string(m.id)] = or_null(summary(row, m.measure));
        if (m.has_extreme) json[extreme_id(m)] = or_null(worst(row, m.measure));
    }
    json["likeness"] = or_null(likeness(row));
    const Spread rate = hz(row);
    json["hz"] = {{"mean", or_null(rate.mean)},
                  {"lower_quartile", or_null(rate.lower_quartile)},
                  {"median", or_null(rate.median)},
                  {"upper_quartile", or_null(rate.upper_quartile)}};
    for (const auto& [id, at] : by_distance) json[id] = to_json(mean_of(row, at));
    json["per_frame"]["frame"] = row.frames;
    for (const MeasureRow& m : measure_table()) {
        Json& all = json["per_frame"][std::string(m.id)] = Json::array();
        for (const Values& v : row.values) all.push_back(or_null(v[m.measure]));
    }
    for (const auto& [id, at] : by_distance) {
        Json& all = json["per_frame"][id] = Json::array();
        for (const Values& v : row.values) all.push_back(to_json(v.*at));
    }
    return json;
}

Row read_row(const Json& json) {
    Row row;
    row.scene = json.at("scene");
    row.path = json.at("path");
    row.method.variant = json.at("method");
    row.method.tessellation = read_tessellation(json.at("tessellation").get<std::string>());
    row.approximate = json.at("approximate");
    row.primitives = json.at("primitives");
    row.error_bound = json.at("error_bound");
    row.cells = json.at("cells");
    row.memory_bytes = json.at("memory_bytes");
    // Older results do without.
    if (const auto found = json.find("cell_numbers"); found != json.end()) row.tessellation = read_cell_numbers(*found);
    row.reference = json.at("reference");
    row.budget = json.at("budget_text");
    row.frames = json.at("per_frame").at("frame").get<std::vector<std::uint32_t>>();
    row.values.resize(row.frames.size());
    for (const MeasureRow& m : measure_table()) {
        const Json& per_frame = json.at("per_frame");
        const auto found = per_frame.find(std::string(m.id));
        if (found == per_frame.end()) continue;  // older than the measure
        const Json& all = *found;
        for (std::size_t i = 0; i < row.values.size(); ++i)
            if (!all.at(i).is_null()) row.values[i][m.measure] = all.at(i);
    }
    for (const auto& [id, at] : by_distance) {
        const auto found = json.at("per_frame").find(id);
        if (found == json.at("per_frame").end()) continue;
        for (std::size_t i = 0; i < row.values.size(); ++i)
            if (const Json& bins = found->at(i); bins.is_array())
                for (std::size_t bin = 0; bin < std::min(distance_bins, bins.size()); ++bin)
                    (row.values[i].*at)[bin] = number_or_nan(bins[bin]);
    }
    return row;
}

std::filesystem::path results_file(const std::string& name) {
    std::error_code error;
    const std::filesystem::path path = name;
    return std::filesystem::is_directory(path, error) ? path / "results.json" : path;
}

bool same_row(const Row& a, const Row& b) {
    return a.scene == b.scene && a.path == b.path && a.method == b.method && a.budget == b.budget &&
           a.error_bound == b.error_bound;
}

}  // namespace

double summary(const Row& row, Measure measure) { return sightline::summary(row.values, measure); }

std::size_t worst_frame(const Row& row, Measure measure) {
    const bool least = measure_row(measure).better == Better::higher;
    std::size_t found = 0;
    for (std::size_t i = 1; i < row.values.size(); ++i) {
        const double a = row.values[i][measure], b = row.values[found][measure];
        if (std::isnan(b) ? !std::isnan(a) : least ? a < b : a > b) found = i;
    }
    return found;
}

double worst(const Row& row, Measure measure) {
    return row.values.empty() ? std::numeric_limits<double>::quiet_NaN()
                              : row.values[worst_frame(row, measure)][measure];
}

Spread hz(const Row& row) {
    std::vector<double> rates;
    for (const Values& v : row.values)
        if (v[Measure::total_ms] > 0) rates.push_back(1000 / v[Measure::total_ms]);
    return spread(rates);
}

DistanceBins mean_of(const Row& row, DistanceBins Values::*at) {
    DistanceBins mean;
    mean.fill(row.values.empty() ? std::numeric_limits<double>::quiet_NaN() : 0);
    for (const Values& v : row.values)
        for (std::size_t bin = 0; bin < distance_bins; ++bin)
            mean[bin] += (v.*at)[bin] / static_cast<double>(row.values.size());
    return mean;
}

double likeness(const Row& row) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> found, visible;
    for (const Values& v : row.values) {
        visible.push_back(v[Measure::visible]);
        found.push_back(v[Measure::visible] > 0 ? v[Measure::coverage] * v[Measure::visible] : 0);
    }
    const auto n = static_cast<double>(found.size());
    if (found.size() < 3) return unknown;
    double mean_x = 0, mean_y = 0, xx = 0, yy = 0, xy = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        mean_x += found[i] / n;
        mean_y += visible[i] / n;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double x = found[i] - mean_x, y = visible[i] - mean_y;
        xx += x * x;
        yy += y * y;
        xy += x * y;
    }
    return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : unknown;
}

std::string results_json(const Results& results, const std::string& claims) {
    Json json{{"format", "sightline-results"},
              {"version", 1},
              {"conditions", Json::parse(conditions_json(results.conditions))},
              {"distance_ends", distance_ends()},
              {"rows", Json::array()}};
    if (!claims.empty()) json["claims"] = Json::parse(claims);
    for (const Row& row : results.rows) json["rows"].push_back(to_json(row));
    if (!results.flights.empty()) json["time_budgets"] = Json::parse(flights_json(results.flights));
    if (!results.wrong_flights.empty()) json["wrong_budgets"] = Json::parse(wrong_flights_json(results.wrong_flights));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Results read_results(std::string_view text, const std::string& name) {
    Results results;
    try {
        const Json json = Json::parse(text);
        if (json.at("format") != "sightline-results") throw InputError(name + ": format: not sightline-results");
        if (json.at("version") != 1) throw InputError(name + ": version: only 1 can be read");
        const Json& c = json.at("conditions");
        results.conditions = {c.at("study").dump(), c.at("build"),    c.value("program", ""),
                              c.at("machine"),      c.at("renderer"), c.at("date")};
        for (const Json& row : json.at("rows")) results.rows.push_back(read_row(row));
        if (const auto flights = json.find("time_budgets"); flights != json.end())
            results.flights = read_flights(flights->dump());
        if (const auto flights = json.find("wrong_budgets"); flights != json.end())
            results.wrong_flights = read_wrong_flights(flights->dump());
    } catch (const Json::exception& error) {
        throw InputError(name + ": not the results of a study: " + one_line(error.what()));
    }
    return results;
}

Results load_results(const std::string& name) {
    const std::string file = results_file(name).string();
    return read_results(read_file(file), file);
}

bool has_results(const std::string& name) {
    std::error_code error;
    return std::filesystem::is_regular_file(results_file(name), error);
}

std::string results_csv(const Results& results) {
    std::string text =
        "scene,path,frames,method,tessellation,error_bound,primitives,cells,memory_bytes,budget_text,budget_share";
    for (const MeasureRow& m : measure_table()) {
        text += ',' + std::string(m.id);
        if (m.has_extreme) text += ',' + extreme_id(m);
    }
    text += ",hz_mean,hz_lower_quartile,hz_median,hz_upper_quartile,likeness\n";
    const auto number = [](double value) { return std::isfinite(value) ? number_text(value) : std::string(); };
    for (const Row& row : results.rows) {
        const Json share = budget_share(row);
        text += csv_field(row.scene) + ',' + csv_field(row.path) + ',' + std::to_string(row.frames.size()) + ',' +
                csv_field(row.method.variant) + ',' + tessellation_word(row.method) + ',' + number(row.error_bound) +
                ',' + std::to_string(row.primitives) + ',' + std::to_string(row.cells) + ',' +
                std::to_string(row.memory_bytes) + ',' + csv_field(row.budget) + ',' +
                (share.is_null() ? "" : number(share));
        for (const MeasureRow& m : measure_table()) {
            text += ',' + number(summary(row, m.measure));
            if (m.has_extreme) text += ',' + number(worst(row, m.measure));
        }
        const Spread rate = hz(row);
        for (const double value : {rate.mean, rate.lower_quartile, rate.median, rate.upper_quartile, likeness(row)})
            text += ',' + number(value);
        text += '\n';
    }
    return text;
}

void write_results(const Results& results, const std::filesystem::path& folder, const std::string& claims) {
    write_file(folder / "results.json", results_json(results, claims));
    write_file(folder / "results.csv", results_csv(results));
}

Results merge(const std::vector<Results>& parts) {
    Results all;
    std::vector<std::string> machines;
    for (const Results& part : parts) {
        if (all.conditions.study.empty()) all.conditions = part.conditions;
        if (part.conditions.study != all.conditions.study)
            throw InputError("merge: two parts belong to different studies: " + excerpt(all.conditions.study) +
                             " and " + excerpt(part.conditions.study));
        if (part.conditions.program != all.conditions.program)
            throw InputError("merge: two parts were measured by different builds of the program");
        if (std::find(machines.begin(), machines.end(), part.conditions.machine) == machines.end())
            machines.push_back(part.conditions.machine);
        for (const Row& row : part.rows) {
            if (std::any_of(all.rows.begin(), all.rows.end(), [&](const Row& r) { return same_row(r, row); }))
                throw InputError("merge: two parts both contain " + excerpt(row.scene) + ", " + excerpt(row.path) +
                                 ", " + excerpt(method_text(row.method)) + ", " + excerpt(row.budget));
            all.rows.push_back(row);
        }
        all.flights.insert(all.flights.end(), part.flights.begin(), part.flights.end());
        all.wrong_flights.insert(all.wrong_flights.end(), part.wrong_flights.begin(), part.wrong_flights.end());
    }
    if (all.conditions.study.empty()) return all;
    all.conditions.machine.clear();
    for (const std::string& machine : machines)
        all.conditions.machine += (all.conditions.machine.empty() ? "" : " and ") + machine;
    const Study study = read_study(all.conditions.study);
    const std::vector<SceneOnPath> on_paths = scenes_on_paths(study);
    const auto place = [&](const Row& row) {
        const auto along = [&](const std::string& path) {
            return std::find_if(on_paths.begin(), on_paths.end(),
                                [&](const SceneOnPath& one) { return one.scene == row.scene && one.path == path; }) -
                   on_paths.begin();
        };
        // A path that was asked for by no name is that which none of the others names.
        auto at = along(row.path);
        if (static_cast<std::size_t>(at) == on_paths.size()) at = along("");
        const auto& bounds = study.error_bounds;
        return std::pair(at, std::find(bounds.begin(), bounds.end(), row.error_bound) - bounds.begin());
    };
    std::stable_sort(all.rows.begin(), all.rows.end(), [&](const Row& a, const Row& b) { return place(a) < place(b); });
    return all;
}

}  // namespace sightline::lab
