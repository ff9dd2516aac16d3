// The lab's study: equal runs, stopping and going on, shards, files that read back, and pixels against a re-render.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include <unistd.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/measure/frame_numbers.h"
#include "core/measure/wrong_region.h"
#include "core/truth/truth.h"
#include "lab/measure/checkpoint.h"
#include "lab/measure/lab_scene.h"
#include "lab/measure/measure_path.h"
#include "lab/measure/run_study.h"
#include "lab/one_run.h"
#include "lab/report/remaining.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;
using M = Measure;

class LabStudy : public testing::Test {
protected:
    void SetUp() override { fs::remove_all(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder(const std::string& name) const { return folder_ / name; }

    static Study small_study() {
        Study study;
        study.scenes = {"2d:rooms", "3d:bottleneck"};
        study.frames = 3;
        study.size = {160, 120};
        study.repeats = 0;
        return study;
    }

    LabGraphics graphics_;

private:
    fs::path folder_ = fs::temp_directory_path() / ("sightline-lab-" + std::to_string(getpid()));
};

/// Equal in every column but times and conditions.
void expect_same_numbers(const Results& a, const Results& b) {
    ASSERT_EQ(a.rows.size(), b.rows.size());
    for (std::size_t r = 0; r < a.rows.size(); ++r) {
        const Row &x = a.rows[r], &y = b.rows[r];
        const std::string where = x.scene + " " + method_text(x.method) + " " + x.budget;
        EXPECT_EQ(x.scene + x.path + method_text(x.method) + x.budget,
                  y.scene + y.path + method_text(y.method) + y.budget);
        EXPECT_EQ(x.error_bound, y.error_bound) << where;
        EXPECT_EQ(x.frames, y.frames) << where;
        EXPECT_EQ(x.cells, y.cells) << where;
        ASSERT_EQ(x.values.size(), y.values.size()) << where;
        for (std::size_t f = 0; f < x.values.size(); ++f)
            for (const MeasureRow& m : measure_table()) {
                const double p = x.values[f][m.measure], q = y.values[f][m.measure];
                EXPECT_TRUE(m.is_time || p == q || (std::isnan(p) && std::isnan(q))) << where << ' ' << m.id;
            }
    }
}

TEST_F(LabStudy, GivesTheSameNumbersTwice) {
    const Study study = small_study();
    const Results first = run_study(study, folder("a"), graphics_), second = run_study(study, folder("b"), graphics_);
    // Five cell methods on two tessellations, centroid and tri-z at four budgets, the conservative ones without.
    ASSERT_EQ(first.rows.size(), 2u * (12 * 4 + 9));
    expect_same_numbers(first, second);
}

TEST_F(LabStudy, OfConservativeMethodsMissesNothing) {
    Study study = small_study();
    study.methods = {parse_method("view"), parse_method("everything")};
    for (const Row& row : run_study(study, folder("a"), graphics_).rows) {
        EXPECT_EQ(row.budget, "unlimited");
        EXPECT_FALSE(row.approximate);
        EXPECT_EQ(summary(row, M::coverage), 1) << row.scene;
        EXPECT_EQ(worst(row, M::wrong), 0) << row.scene;
    }
}

TEST_F(LabStudy, HasViewCullingAndExactlyVBesideTheMethods) {
    Study study = small_study();
    study.scenes = {"3d:bottleneck"};
    study.methods = {parse_method("cplp"), parse_method("view")};
    study.budgets = {parse_budget("5%")};
    study.repeats = 1;
    add_baselines(study);
    add_baselines(study);
    ASSERT_EQ(study.methods.size(), 3u);
    const Results results = run_study(study, folder("a"), graphics_);
    const Row &cplp = results.rows.at(0), &view = results.rows.at(1), &exact = results.rows.at(2);
    EXPECT_EQ(exact.method.variant, exactly_v);
    EXPECT_EQ(exact.budget, "unlimited");
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
        const Values &v = exact.values[i], &c = cplp.values[i];
        EXPECT_EQ(v[M::emitted_over_visible], 1);
        EXPECT_EQ(v[M::wrong], 0);
        EXPECT_TRUE(std::isnan(v[M::traverse_ms])) << "it is told what is visible";
        EXPECT_GT(c[M::tested], 0);
        EXPECT_GE(c[M::rounds], 1);
        EXPECT_GE(c[M::emitted_over_visible], 1);
        EXPECT_EQ(view.values[i][M::tested], 0);
        EXPECT_TRUE(std::isnan(view.values[i][M::rounds]));
        if (!graphics_.has_opengl()) continue;
        EXPECT_EQ(v[M::over_exact], 1);
        EXPECT_DOUBLE_EQ(v[M::total_ms], v[M::upload_ms] + v[M::draw_ms]);
        EXPECT_DOUBLE_EQ(c[M::over_exact], c[M::total_ms] / v[M::total_ms]);
        EXPECT_DOUBLE_EQ(c[M::total_ms], c[M::traverse_ms] + c[M::upload_ms] + c[M::draw_ms]);
    }
    const auto json = nlohmann::json::parse(results_json(results));
    EXPECT_EQ(json["distance_ends"].size(), distance_bins);
    if (graphics_.has_opengl()) {
        EXPECT_DOUBLE_EQ(json["rows"][0]["hz"]["median"].get<double>(), hz(cplp).median);
    }
}

TEST_F(LabStudy, CountsWrongPixelsByDistance) {
    Study study = small_study();
    study.methods = {parse_method("centroid")};
    study.budgets = {parse_budget("2%")};
    for (const Row& row : run_study(study, folder("a"), graphics_).rows)
        for (const Values& v : row.values) {
            double wrong = 0;
            for (std::size_t bin = 0; bin < distance_bins; ++bin) {
                EXPECT_LE(v.wrong_at[bin], v.pixels_at[bin]);
                wrong += v.wrong_at[bin];
            }
            EXPECT_GT(wrong, 0) << row.scene;
            EXPECT_NEAR(wrong, v[M::wrong], 1e-12) << row.scene;
        }
}

TEST_F(LabStudy, GoesOnWhereItWasStopped) {
    const Study study = small_study();
    int frames = 0;
    StudyRun stopping;
    stopping.stopped = [&] { return ++frames == 2; };  // inside the first path
    const Results none = run_study(study, folder("a"), graphics_, stopping);
    EXPECT_TRUE(none.rows.empty()) << "a path that is not complete gives no rows";
    std::string file = read_file(folder("a") / "frames.jsonl");
    EXPECT_EQ(std::count(file.begin(), file.end(), '\n'), 3) << "the study and two frames";
    write_file(folder("a") / "frames.jsonl", file + R"({"scene": "2d:rooms", "pat)");  // cut while writing
    int measured = 0;
    StudyRun going_on;
    going_on.stopped = [&] { return ++measured < 0; };
    const Results rest = run_study(study, folder("a"), graphics_, going_on);
    expect_same_numbers(rest, run_study(study, folder("b"), graphics_));
    file = read_file(folder("a") / "frames.jsonl");
    EXPECT_EQ(std::count(file.begin(), file.end(), '\n'), 7) << "each frame once";
}

TEST_F(LabStudy, DoesNotMixWithAnother) {
    Study study = small_study();
    study.scenes = {"2d:rooms"};
    run_study(study, folder("a"), graphics_);
    study.budgets = {parse_budget("3%")};
    EXPECT_THROW(run_study(study, folder("a"), graphics_), InputError);
}

TEST_F(LabStudy, NamesWhatDoesNotExistBeforeItMeasures) {
    Study study = small_study();
    for (const char* wrong : {"2d:nosuch", "3d:nosuch"}) {
        study.scenes = {"2d:rooms", wrong};
        EXPECT_THROW(run_study(study, folder("a"), graphics_), InputError);
        EXPECT_FALSE(fs::exists(folder("a"))) << wrong;
    }
    study.scenes = {"city:10k", "2d:rooms"};
    study.paths = {"street"};  // of the city only
    EXPECT_THROW(run_study(study, folder("a"), graphics_), InputError);
    EXPECT_FALSE(fs::exists(folder("a")));
    study.scenes = {"2d:rooms"};
    study.paths = {"turn", "nosuch"};
    EXPECT_THROW(run_study(study, folder("a"), graphics_), InputError);
    EXPECT_FALSE(fs::exists(folder("a")));
}

/// What changes under a study that was stopped must not be mixed with what it measured before.
TEST_F(LabStudy, TakesNoFramesOfAnotherBuildMachineOrScene) {
    Study study = small_study();
    const fs::path scene = folder("scene.json"), file = folder("a") / "frames.jsonl";
    const auto segments = [&](const char* end) {
        write_file(
            scene,
            std::string(
                R"({"format":"sightline-scene","version":1,"dimension":2,"view":{"eye":[0.5,0.5],"look_at":[0.5,2]},"segments":[[0,0,1,0],[0,1,)") +
                end + R"(,1],[0,2,1,2]]})");
    };
    fs::create_directories(folder("."));
    segments("1");
    study.scenes = {scene.string()};
    run_study(study, folder("a"), graphics_);
    const std::string first = read_file(file);
    EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 4);
    run_study(study, folder("a"), graphics_);
    EXPECT_EQ(read_file(file), first) << "finished";

    segments("2");
    const Results changed = run_study(study, folder("a"), graphics_);
    expect_same_numbers(changed, run_study(study, folder("b"), graphics_));
    const std::string second = read_file(file);
    EXPECT_EQ(std::count(second.begin(), second.end(), '\n'), 7) << "the other scene's frames are measured";

    for (const char* field : {"program", "machine", "renderer"}) {
        auto head = nlohmann::ordered_json::parse(second.substr(0, second.find('\n')));
        head[field] = "another";
        head.erase("hash");
        write_file(file, checkpoint_line(head.dump()) + second.substr(second.find('\n')));
        const std::string other = read_file(file);
        std::vector<std::string> said;
        run_study(study, folder("a"), graphics_, {.say = [&](const std::string& line) { said.push_back(line); }});
        EXPECT_EQ(read_file(file.string() + ".old"), other) << field;
        const std::string anew = read_file(file);
        EXPECT_EQ(std::count(anew.begin(), anew.end(), '\n'), 4) << field;
        EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const std::string& line) {
            return line.find("measured again") != line.npos;
        })) << field;
    }
}

TEST(LabRemaining, FollowsWhatWasMeasured) {
    Remaining remaining(4);
    EXPECT_EQ(remaining.text_after(1), "") << "nothing is known yet";
    remaining.kept(1);
    EXPECT_EQ(remaining.text_after(1), "");
    remaining.done(0.5);
    EXPECT_EQ(remaining.text_after(10), ", about 50 s left") << "2.5 more at 20 s each";
    remaining.done(0.5);
    EXPECT_EQ(remaining.text_after(60), ", about 2 min 0 s left");
    remaining.done(2.5);
    EXPECT_EQ(remaining.text_after(100), ", about 0 s left");
}

TEST_F(LabStudy, InPartsIsTheWhole) {
    Study study = small_study();
    study.scenes = {"2d:rooms", "3d:bottleneck", "2d:bottleneck"};
    study.paths = {"turn", "start"};
    study.error_bounds = {0.5, 0.3};
    study.frames = 2;
    study.methods = {parse_method("published"), parse_method("view")};
    study.budgets = {parse_budget("5%")};
    const Results whole = run_study(study, folder("whole"), graphics_);
    std::vector<Results> parts;
    for (const std::uint32_t index : {3u, 1u, 4u, 2u, 0u}) {
        StudyRun run;
        run.shard = {index, 5};
        const Results part = run_study(study, folder("part" + std::to_string(index)), graphics_, run);
        parts.push_back(read_results(results_json(part), "part"));
    }
    EXPECT_EQ(whole.rows.size(), 3u * 2 * 2 * 2);
    for (const Results& part : parts) EXPECT_LE(part.rows.size(), 3u * 2) << "of twelve units two or three";
    parts.front().conditions.machine = "another";
    const Results merged = merge(parts);
    expect_same_numbers(merged, whole);
    EXPECT_EQ(merged.conditions.machine, "another and " + whole.conditions.machine);
    parts.push_back(parts.back());
    EXPECT_THROW(merge(parts), InputError) << "the same rows twice";
    parts.pop_back();
    std::vector<Results> others = parts;
    Study other = study;
    other.frames = 1;
    others.back().conditions.study = study_json(other);
    EXPECT_THROW(merge(others), InputError) << "another study";
    others = parts;
    others.back().conditions.program = "another";
    EXPECT_THROW(merge(others), InputError) << "another build";
}

TEST_F(LabStudy, ReadsItsOwnFiles) {
    Study study = small_study();
    study.repeats = 1;
    const Results results = run_study(study, folder("a"), graphics_);
    const std::string text = results_json(results);
    EXPECT_EQ(results_json(read_results(text, "results.json")), text);
    for (const Row& row : results.rows) {
        EXPECT_GT(summary(row, M::traverse_ms), 0);
        EXPECT_EQ(std::isnan(summary(row, M::draw_ms)), row.scene == "2d:rooms") << "only 3D is drawn";
    }
    const std::string csv = results_csv(results);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), results.rows.size() + 1);
    const std::string header = csv.substr(0, csv.find('\n'));
    const auto fields = [](const std::string& line) { return std::count(line.begin(), line.end(), ',') + 1; };
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) EXPECT_EQ(fields(line), fields(header)) << line;
    // Written before there was such a measure.
    auto older = nlohmann::ordered_json::parse(text);
    for (auto& row : older["rows"]) row["per_frame"].erase("total_error_ms");
    const Results old = read_results(older.dump(), "older");
    EXPECT_EQ(old.rows[0].values[0][M::total_ms], results.rows[0].values[0][M::total_ms]);
    EXPECT_TRUE(std::isnan(old.rows[0].values[0][M::total_error]));
    for (const char* bad : {"", "[]", "{}", R"({"format": "sightline-results", "version": 2})",
                            R"({"format": "sightline-results", "version": 1, "conditions": {}, "rows": []})"})
        EXPECT_THROW(read_results(bad, "bad"), InputError) << bad;
}

Row timed_row(std::initializer_list<double> wrong, std::initializer_list<double> times) {
    Row row;
    for (const double w : wrong) {
        row.values.emplace_back();
        row.values.back()[M::wrong] = w;
    }
    std::size_t i = 0;
    for (const double t : times) row.values[i++][M::total_ms] = t;
    return row;
}

TEST(LabResults, SumUpAsTheTableSays) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Row row = timed_row({0.1, nan, 0.4, 0.1}, {5, 1, 100, 2});
    EXPECT_DOUBLE_EQ(summary(row, M::wrong), 0.2);
    EXPECT_DOUBLE_EQ(worst(row, M::wrong), 0.4);
    EXPECT_EQ(worst_frame(row, M::wrong), 2u);
    EXPECT_DOUBLE_EQ(summary(row, M::total_ms), 3.5) << "the median";
    EXPECT_TRUE(std::isnan(summary(row, M::pop)));
    const double visible[] = {10, 20, 30, 40}, coverage[] = {0.5, 0.5, 0.5, 0.5};
    for (std::size_t i = 0; i < 4; ++i) {
        row.values[i][M::visible] = visible[i];
        row.values[i][M::coverage] = coverage[i];
    }
    EXPECT_DOUBLE_EQ(likeness(row), 1) << "half of the visible ones in each frame";
    row.values[3][M::coverage] = 5 / 40.0;
    row.values[0][M::coverage] = 2;
    EXPECT_LT(likeness(row), 0);
    EXPECT_DOUBLE_EQ(worst(row, M::coverage), 0.125) << "the least is the worst";
}

TEST(LabStudyPaths, AScenePathAndAPartOfOneAreTaken) {
    Study study;
    study.scenes = {"2d:rooms", "city:10k@air", "city:10k@street:60-67"};
    study.paths = {"turn", "start"};
    std::vector<std::string> all;
    for (const SceneOnPath& one : scenes_on_paths(study)) all.push_back(one.scene + " " + one.path);
    EXPECT_EQ(all,
              (std::vector<std::string>{"2d:rooms turn", "2d:rooms start", "city:10k air", "city:10k street:60-67"}));
    EXPECT_TRUE(has_3d(study));
    EXPECT_FALSE(part_of_path("street"));
    EXPECT_FALSE(part_of_path("street:7-6"));
    EXPECT_FALSE(part_of_path("a-b:c"));
    Study one_path;
    one_path.methods = {parse_method("view")};
    const auto part = load_lab_scene<3>("city:10k", "street:60-67", one_path),
               whole = load_lab_scene<3>("city:10k", "street", one_path);
    ASSERT_EQ(part.specs.size(), 8u);
    EXPECT_TRUE(std::equal(part.specs.begin(), part.specs.end(), whole.specs.begin() + 60));
    EXPECT_EQ(part.path, "street:60-67");
    EXPECT_THROW(load_lab_scene<3>("city:10k", "street:60-160", one_path), InputError);
    EXPECT_THROW(load_lab_scene<3>("city:10k", "nosuch:0-1", one_path), InputError);
}

TEST(LabStudyNames, SayWhichDimension) {
    EXPECT_EQ(parse_scene("city").dimension, 3);
    EXPECT_EQ(parse_scene("city:50k").dimension, 3);
    EXPECT_EQ(parse_scene("rooms").dimension, 2);
    EXPECT_EQ(parse_scene("bottleneck").dimension, 3);
    EXPECT_EQ(parse_scene("2d:bottleneck").name, "bottleneck");
    EXPECT_EQ(parse_scene("2d:bottleneck").dimension, 2);
    EXPECT_EQ(parse_scene("town.GeoJSON").dimension, 2);
    EXPECT_EQ(parse_scene("freedoom1#E1M2").dimension, 2);
    EXPECT_EQ(parse_scene("bunny.obj").dimension, 3);
    EXPECT_EQ(method_text(parse_method("published@tree")), "published@tree");
    EXPECT_EQ(parse_method("published@kd on_reenqueue=min").tessellation, Tessellation::kd);
    EXPECT_EQ(method_text(parse_method("published@kd on_reenqueue=min")), "published@kd on_reenqueue=min");
    EXPECT_EQ(read_tessellation("kd"), Tessellation::kd);
    EXPECT_THROW(read_tessellation("k-d"), InputError);
    EXPECT_THROW(parse_method("published@k"), InputError);
    EXPECT_THROW(parse_method("publishd"), InputError);
    EXPECT_EQ(parse_shard("2/5").index, 1u);
    for (const char* bad : {"", "2", "0/3", "4/3", "a/b", "1/0"}) EXPECT_THROW(parse_shard(bad), InputError) << bad;
}

/// One budget of one frame, found by a run of its own.
struct Alone {
    std::vector<std::uint8_t> visible, rendered, wrong;
};

template <int D>
Alone alone(const LabScene<D>& lab, std::size_t frame, const Row& row, const DrawIds& draw_ids) {
    const CellComplex<D>* cells = &lab.on(row.method.tessellation);
    const Truth truth =
        make_truths<D>(*lab.scene, {&cells, 1}, lab.views[frame], lab.settings.reference_size, draw_ids, false).front();
    Settings settings = lab.settings_for(row.method);
    settings.budget = parse_budget(row.budget);
    Alone result{truth.reference.visible,
                 one_run<D>(lab.tables.template of<D>(), *lab.scene, *cells, lab.views[frame], settings, {}).rendered,
                 {}};
    for (const std::uint32_t id : truth.reference.image.ids) result.wrong.push_back(id != none && !result.rendered[id]);
    return result;
}

/// What changes from frame to frame, against runs of their own that know nothing of each other. Another set in place of
/// the right one gives another number: each row has to differ from what the other sets would give.
template <int D>
void expect_changes_of_separate_runs(const std::string& scene, std::size_t& told_apart) {
    Study study;
    study.scenes = {scene};
    study.frames = 4;
    study.methods = {parse_method("published"), parse_method("layers@tree"), parse_method("published@kd"),
                     parse_method("centroid")};
    study.budgets = {parse_budget("2%"), parse_budget("8%")};
    study.size = {D == 2 ? 2048 : 160, 120};
    study.repeats = 0;
    LabGraphics graphics;
    Instruments instruments;
    instruments.draw_ids = graphics.draw_ids();
    const LabScene<D> lab = load_lab_scene<D>(scene, "", study);
    for (const Row& row : measure_path<D>(lab, study, instruments)) {
        EXPECT_TRUE(std::isnan(row.values[0][M::pop]) && std::isnan(row.values[0][M::flip]));
        for (std::size_t i = 1; i < row.values.size(); ++i) {
            const Alone before = alone<D>(lab, i - 1, row, instruments.draw_ids),
                        now = alone<D>(lab, i, row, instruments.draw_ids);
            std::size_t both = 0, either = 0, popped = 0, flipped = 0, rendered_changed = 0;
            for (std::size_t p = 0; p < now.visible.size(); ++p) {
                both += before.visible[p] && now.visible[p];
                either += before.visible[p] || now.visible[p];
                popped += before.visible[p] && now.visible[p] && before.rendered[p] != now.rendered[p];
                rendered_changed += before.rendered[p] != now.rendered[p];
            }
            for (std::size_t p = 0; p < now.wrong.size(); ++p) flipped += before.wrong[p] != now.wrong[p];
            const std::string where = scene + " " + method_text(row.method) + " " + row.budget;
            const Values& v = row.values[i];
            if (both > 0) {
                EXPECT_DOUBLE_EQ(v[M::pop], double(popped) / double(both)) << where;
            }
            EXPECT_DOUBLE_EQ(v[M::flip], double(flipped) / double(now.wrong.size())) << where;
            EXPECT_DOUBLE_EQ(v[M::visible_change], 1 - double(both) / double(either)) << where;
            told_apart += popped > 0 && flipped > 0 && rendered_changed != popped && both != either;
        }
    }
}

TEST(LabChanges, AreThoseOfSeparateRuns) {
    std::size_t told_apart = 0;
    expect_changes_of_separate_runs<2>("2d:streets", told_apart);
    expect_changes_of_separate_runs<3>("city:10k", told_apart);
    EXPECT_GT(told_apart, 15u) << "else another set would give the same";
}

/// Draws only what was rendered, and counts the pixels that differ from the exact image.
TEST(LabPixels, ByIdsAreThoseOfARerender) {
    LabGraphics graphics;
    const DrawIds draw_ids = graphics.draw_ids();
    Study study;
    study.scenes = {"city:10k", "room:10k", "jungle:10k"};
    study.size = {320, 240};
    study.frames = 2;
    study.repeats = 0;
    study.methods = {parse_method("layers")};
    std::size_t all_wrong = 0;
    for (const std::string& name : study.scenes) {
        const LabScene<3> lab = load_lab_scene<3>(name, "", study);
        for (const View<3>& view : lab.views) {
            const CellComplex<3>* cells = &lab.on(Tessellation::delaunay);
            const Truth truth = make_truths<3>(*lab.scene, {&cells, 1}, view, study.size, draw_ids).front();
            const Method<3>& layers = find_method<3>(method_table<3>(), "layers");
            const WholeRun run =
                whole_run<3>(layers, make_problem(layers, lab.settings.parameters, *lab.scene, *cells, view),
                             truth.reference, false);
            const auto budget = static_cast<std::uint32_t>(lab.scene->primitives.size() / 400);
            const auto rendered = rendered_by(run, cut_at(run, budget).met, lab.scene->primitives.size());
            Scene<3> part;
            part.up_axis = lab.scene->up_axis;
            std::vector<std::uint32_t> id_of;
            for (std::uint32_t p = 0; p < rendered.size(); ++p) {
                if (!rendered[p]) continue;
                part.primitives.push_back(lab.scene->primitives[p]);
                if (!lab.scene->two_sided.empty()) part.two_sided.push_back(lab.scene->two_sided[p]);
                id_of.push_back(p);
            }
            const IdImage again = draw_ids(part, view, study.size, 1).front();
            const IdImage& exact = truth.reference.image;
            std::size_t differ = 0, wrong = 0;
            for (std::size_t i = 0; i < exact.ids.size(); ++i) {
                const std::uint32_t id = again.ids[i] == none ? none : id_of[again.ids[i]];
                differ += id != exact.ids[i];
            }
            for (const std::uint8_t w : wrong_mask(exact, rendered)) wrong += w;
            all_wrong += wrong;
            EXPECT_LE(differ > wrong ? differ - wrong : wrong - differ, 1u) << name;
        }
    }
    EXPECT_GT(all_wrong, 1000u) << "budgets that miss nothing test nothing";
}

}  // namespace
}  // namespace sightline::lab
