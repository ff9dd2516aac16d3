// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/run_study.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "lab/measure/checkpoint.h"
#include "lab/measure/measure_path.h"
#include "lab/measure/time_budget.h"
#include "lab/measure/wrong_budget.h"
#include "lab/report/remaining.h"
#include "lab/report/say.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

/// All of a frame's numbers in one order, to write and to read them.
template <typename AnyValues, typename Each>
void for_each_value(AnyValues& values, Each each) {
    for (auto& value : values.all) each(value);
    for (auto* const at : {&values.wrong_at, &values.pixels_at})
        for (auto& value : *at) each(value);
}

std::string frame_json(const FrameResult& result) {
    Json values = Json::array();
    for (const Values& v : result.values) {
        Json one = Json::array();
        for_each_value(v, [&](double value) { one.push_back(std::isfinite(value) ? Json(value) : Json(nullptr)); });
        values.push_back(std::move(one));
    }
    return values.dump();
}

FrameResult read_frame(std::uint32_t frame, const std::string& text) {
    FrameResult result{frame, {}};
    for (const Json& one : Json::parse(text)) {
        Values& v = result.values.emplace_back();
        std::size_t i = 0;
        for_each_value(v, [&](double& value) {
            if (const Json& kept = one.at(i++); !kept.is_null()) value = kept;
        });
    }
    return result;
}

/// One scene, path and, where the study has several, error bound.
struct Unit {
    std::string scene, path;
    double error_bound = 0;
    Study study;  ///< at that bound
};

std::vector<Unit> units_of(const Study& study, const Shard& shard) {
    const std::vector<double> bounds = study.error_bounds.empty() ? std::vector<double>{0} : study.error_bounds;
    std::vector<Unit> units;
    std::size_t index = 0;
    for (const auto& [scene, path] : scenes_on_paths(study))
        for (const double bound : bounds)
            if (index++ % shard.count == shard.index)
                units.push_back({scene, path, bound, at_error_bound(study, bound)});
    return units;
}

/// Opened once something that exists is to be measured.
using Opened = std::function<Checkpoint&()>;

/// False when it was stopped: then no rows were added.
template <int D>
bool measure(const Unit& unit, LabGraphics& graphics, const StudyRun& run, const Opened& opened, Remaining& remaining,
             Results& results) {
    std::string what = excerpt(unit.scene);
    if (unit.error_bound > 0) what += ", error bound " + short_number(unit.error_bound);
    if (run.say) run.say(what + ": reading and tessellating" + remaining.text());
    const LabScene<D> lab = load_lab_scene<D>(unit.scene, unit.path, unit.study);
    Checkpoint& checkpoint = opened();
    what += ", path " + excerpt(lab.path);
    const std::size_t frames = lab.frames.size();
    const double share = 1 / static_cast<double>(frames);
    const std::string key = checkpoint_key(lab);
    const auto key_of = [&](std::uint32_t frame) { return key + ", frame " + std::to_string(frame); };

    Instruments instruments;
    instruments.draw_ids = graphics.draw_ids();
    // Without OpenGL nothing is drawn that could be timed.
    if (D == 3 && graphics.has_opengl()) instruments.time_drawing = graphics.time_drawing(unit.study.size);
    bool complete = frames == 0;
    instruments.finished = [&](std::uint32_t frame) -> std::optional<FrameResult> {
        const std::string* piece = checkpoint.find(key_of(frame));
        return piece ? std::optional(read_frame(frame, *piece)) : std::nullopt;
    };
    instruments.frame_done = [&](const FrameResult& frame) {
        if (checkpoint.find(key_of(frame.frame))) {
            remaining.kept(share);
        } else {
            checkpoint.add(key_of(frame.frame), frame_json(frame));
            remaining.done(share);
        }
        complete = frame.frame + 1 == frames;
        if (run.say)
            run.say(what + ": frame " + std::to_string(frame.frame + 1) + " of " + std::to_string(frames) +
                    remaining.text());
        return complete || !run.stopped || !run.stopped();
    };
    const std::vector<Row> rows = measure_path<D>(lab, unit.study, instruments);
    if (!complete) return false;
    results.rows.insert(results.rows.end(), rows.begin(), rows.end());
    if (!unit.study.wrong_budgets.empty()) {
        const std::string piece = key + ", budgets in wrong pixels";
        const std::string* kept = checkpoint.find(piece);
        if (!kept && run.say) run.say(what + ": following wrong pixels" + remaining.text());
        bool stopped = false;
        const std::vector<WrongFlight> flights =
            kept ? read_wrong_flights(*kept) : fly_in_wrong_pixels(lab, unit.study, instruments.draw_ids, [&] {
                return !(stopped = run.stopped && run.stopped());
            });
        if (stopped) return false;
        if (!kept) checkpoint.add(piece, wrong_flights_json(flights));
        results.wrong_flights.insert(results.wrong_flights.end(), flights.begin(), flights.end());
    }
    if constexpr (D == 3) {
        if (const std::string* kept = checkpoint.find(key + ", time budgets")) {
            for (TimedFlight& flight : read_flights(*kept)) results.flights.push_back(std::move(flight));
        } else {
            if (run.say) run.say(what + ": flying with budgets in time" + remaining.text());
            bool stopped = false;
            const auto flights =
                fly_in_time(lab, unit.study, instruments, [&] { return !(stopped = run.stopped && run.stopped()); });
            if (stopped) return false;
            if (!flights.empty()) checkpoint.add(key + ", time budgets", flights_json(flights));
            results.flights.insert(results.flights.end(), flights.begin(), flights.end());
        }
    }
    return !run.stopped || !run.stopped();
}

}  // namespace

Shard parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto index = parse_whole(std::string_view(text).substr(0, slash));
    const auto count =
        slash == std::string::npos ? std::nullopt : parse_whole(std::string_view(text).substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count)
        throw InputError("--shard '" + excerpt(text) + "': write I/N with I from 1 to N, such as 2/5");
    return {*index - 1, *count};
}

void check_scenes(const Study& study, const std::function<void(const std::string& line)>& say) {
    std::vector<std::string> scenes;
    std::map<std::string, std::vector<std::string>> paths;
    for (const auto& [scene, path] : scenes_on_paths(study)) {
        if (paths[scene].empty()) scenes.push_back(scene);
        paths[scene].push_back(path);
    }
    for (const std::string& scene : scenes) {
        if (say) say(excerpt(scene) + ": checking");
        if (parse_scene(scene).dimension == 2)
            check_scene<2>(scene, paths[scene], study);
        else
            check_scene<3>(scene, paths[scene], study);
    }
}

Results run_study(const Study& study, const std::filesystem::path& folder, LabGraphics& graphics, const StudyRun& run) {
    if (scenes_on_paths(study).size() > 1) check_scenes(study, run.say);
    Results results{conditions_here(study_json(study), has_3d(study) ? graphics.description() : ""), {}};
    std::optional<Checkpoint> checkpoint;
    const Opened opened = [&]() -> Checkpoint& {
        if (checkpoint) return *checkpoint;
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        if (error) throw WorkError(folder.string() + ": " + error.message());
        checkpoint.emplace(folder / "frames.jsonl", results.conditions);
        for (const std::string& damage : checkpoint->damages()) warn(damage);
        if (run.say && checkpoint->began_anew() && checkpoint->damages().empty())
            run.say(
                "frames of another build, machine or renderer are measured again; the old ones are in "
                "frames.jsonl.old");
        return *checkpoint;
    };
    const std::vector<Unit> units = units_of(study, run.shard);
    Remaining remaining(static_cast<double>(units.size()));
    for (const Unit& unit : units) {
        const bool go_on = parse_scene(unit.scene).dimension == 2
                               ? measure<2>(unit, graphics, run, opened, remaining, results)
                               : measure<3>(unit, graphics, run, opened, remaining, results);
        if (!go_on) break;
    }
    if (units.empty()) opened();  // a part with nothing to do has a folder too
    return results;
}

}  // namespace sightline::lab
