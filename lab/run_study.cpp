// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/run_study.h"

#include "core/error.h"
#include "core/number.h"
#include "core/stopwatch.h"
#include "lab/checkpoint.h"
#include "lab/lab_scene.h"

namespace sightline::lab {

namespace {

/// Remaining time out of how long the frames so far took, taking each path for as long as the one under way.
class Clock {
public:
    Clock(std::size_t paths, const StudyRun& run) : paths_(paths), run_(run) {}

    void next_path(const std::string& what, std::size_t frames) {
        ++path_;
        what_ = what;
        frames_ = frames;
        done_ = 0;
    }
    void frame_done() {
        ++done_;
        ++all_done_;
        if (!run_.say) return;
        const double left = static_cast<double>(frames_ - done_ + (paths_ - path_) * frames_);
        run_.say(what_ + ": frame " + std::to_string(done_) + " of " + std::to_string(frames_) + ", path " +
                 std::to_string(path_) + " of " + std::to_string(paths_) + ", about " +
                 duration_text(stopwatch_.milliseconds() / 1000 / static_cast<double>(all_done_) * left) + " left");
    }

private:
    std::size_t paths_, path_ = 0, frames_ = 0, done_ = 0, all_done_ = 0;
    const StudyRun& run_;
    std::string what_;
    Stopwatch stopwatch_;
};

/// False when it was stopped: then no rows were added.
template <int D>
bool measure(const std::string& name, const std::string& path, const Study& study, LabGraphics& graphics,
             const StudyRun& run, Checkpoint& checkpoint, Clock& clock, Results& results) {
    if (run.say) run.say(name + ": reading and tessellating");
    const LabScene<D> lab = load_lab_scene<D>(name, path, study);
    clock.next_path(name + ", path " + lab.path, lab.frames.size());
    Instruments instruments;
    instruments.draw_ids = graphics.draw_ids();
    instruments.time_drawing = graphics.time_drawing(study.size);
    bool complete = true;
    instruments.finished = [&](std::uint32_t frame) { return checkpoint.find(name, lab.path, frame); };
    instruments.frame_done = [&](const FrameResult& frame) {
        if (!checkpoint.find(name, lab.path, frame.frame)) checkpoint.add(name, lab.path, frame);
        clock.frame_done();
        complete = frame.frame + 1 == lab.frames.size();
        return complete || !run.stopped || !run.stopped();
    };
    const std::vector<Row> rows = measure_path<D>(lab, study, instruments);
    if (!complete) return false;
    results.rows.insert(results.rows.end(), rows.begin(), rows.end());
    return !run.stopped || !run.stopped();
}

}  // namespace

Shard parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto index = parse_whole(std::string_view(text).substr(0, slash));
    const auto count =
        slash == std::string::npos ? std::nullopt : parse_whole(std::string_view(text).substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count)
        throw InputError("--shard '" + text + "': write I/N with I from 1 to N, such as 2/5");
    return {*index - 1, *count};
}

Results run_study(const Study& study, const std::filesystem::path& folder, LabGraphics& graphics, const StudyRun& run) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw WorkError(folder.string() + ": " + error.message());
    Checkpoint checkpoint(folder / "frames.jsonl", study_json(study));
    struct Unit {
        const std::string &scene, &path;
    };
    std::vector<Unit> units;
    std::size_t index = 0;
    for (const std::string& scene : study.scenes)
        for (const std::string& path : study.paths)
            if (index++ % run.shard.count == run.shard.index) units.push_back({scene, path});
    Results results;
    Clock clock(units.size(), run);
    for (const Unit& unit : units) {
        const bool go_on = parse_scene(unit.scene).dimension == 2
                               ? measure<2>(unit.scene, unit.path, study, graphics, run, checkpoint, clock, results)
                               : measure<3>(unit.scene, unit.path, study, graphics, run, checkpoint, clock, results);
        if (!go_on) break;
    }
    results.conditions = conditions_here(study, graphics.description());
    return results;
}

}  // namespace sightline::lab
