// The lab's other instruments: comparing, choosing cells, reducing, and the files between them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/random.h"
#include "core/session/condition.h"
#include "core/session/settings_file.h"
#include "core/session/settings_table.h"
#include "lab/cells/cells_report.h"
#include "lab/command.h"
#include "lab/compare/compare_report.h"
#include "lab/compare/fail_if.h"
#include "lab/measure/run_study.h"
#include "lab/reduce/reduce.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;
using M = Measure;

Row row_of(const std::string& method, std::uint32_t cells, std::vector<double> wrong, double ms = 1,
           const std::string& budget = "5%") {
    Row row;
    row.scene = "city";
    row.path = "test";
    row.method = parse_method(method);
    row.budget = budget;
    row.cells = cells;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        row.frames.push_back(static_cast<std::uint32_t>(10 * i));
        row.values.emplace_back();
        row.values.back()[M::wrong] = wrong[i];
        row.values.back()[M::coverage] = 1 - wrong[i];
        row.values.back()[M::total_ms] = ms;
    }
    return row;
}

TEST(LabCompare, PairsFrames) {
    const Row a = row_of("layers", 1, {0.1, 0.2, 0.3, 0.4}), b = row_of("layers", 1, {0.2, 0.2, 0.5, 0.5});
    const Change change = *change_of(a, b, M::wrong);
    EXPECT_EQ(change.frames, 4u);
    EXPECT_DOUBLE_EQ(change.a, 0.25);
    EXPECT_DOUBLE_EQ(change.b, 0.35);
    EXPECT_DOUBLE_EQ(change.mean, 0.1);
    // Differences 0.1, 0, 0.2, 0.1: s = sqrt(0.02 / 3), t(3) = 3.182.
    EXPECT_NEAR(change.half_width, 3.182 * std::sqrt(0.02 / 3) / 2, 1e-12);
    EXPECT_FALSE(change.significant());
    EXPECT_EQ(change.lost, 2u);
    EXPECT_EQ(change.gained, 1u);
    const Change coverage = *change_of(a, b, M::coverage);
    EXPECT_EQ(coverage.lost, 2u) << "less coverage is a loss";
    const Change clear = *change_of(a, row_of("layers", 1, {0.2, 0.3, 0.4, 0.51}), M::wrong);
    EXPECT_TRUE(clear.significant());
    EXPECT_NE(change_text(clear).find(": worse"), std::string::npos) << change_text(clear);
    EXPECT_NE(change_text(change).find("within the noise"), std::string::npos);
    EXPECT_NE(change_text(*change_of(a, a, M::wrong)).find("same"), std::string::npos);

    Row later = row_of("layers", 1, {0.9, 0.1});
    later.frames = {30, 20};  // other frames, in another order
    const Change matched = *change_of(a, later, M::wrong);
    EXPECT_EQ(matched.frames, 2u);
    EXPECT_DOUBLE_EQ(matched.mean, (0.9 - 0.4 + 0.1 - 0.3) / 2);
    EXPECT_EQ(matched.lost, 3u);
    later.frames = {7, 8};
    EXPECT_FALSE(change_of(a, later, M::wrong));
    EXPECT_FALSE(change_of(a, a, M::pop)) << "neither has it";
}

TEST(LabCompare, TimesAreHeldAgainstTheirRepeats) {
    const auto timed = [](std::vector<double> ms, double error) {
        Row row = row_of("layers", 1, std::vector<double>(ms.size(), 0.1));
        for (std::size_t i = 0; i < ms.size(); ++i) {
            row.values[i][M::total_ms] = ms[i];
            row.values[i][M::total_error] = error;
        }
        return row;
    };
    const auto change = [&](const Row& a, const Row& b) { return *change_of(a, b, M::total_ms); };
    // One frame: t(2) = 4.303 times the root of 0.3² + 0.4².
    const Row one = timed({10}, 0.3);
    EXPECT_NEAR(change(one, timed({11}, 0.4)).half_width, 4.303 * 0.5, 1e-12);
    EXPECT_FALSE(change(one, timed({11}, 0.4)).significant());
    EXPECT_TRUE(change(one, timed({13}, 0.4)).significant());
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(change(timed({10}, unknown), timed({99}, unknown)).significant()) << "timed once";
    // Four frames that all changed by the same: only the repeats say how well that is known; t(8) = 2.306.
    const Row four = timed({10, 20, 30, 40}, 0.3);
    EXPECT_NEAR(change(four, timed({11, 21, 31, 41}, 0.4)).half_width, 2.306 * std::sqrt(4 * 0.25) / 4, 1e-12);
    // Frames that changed differently are noisier than the repeats.
    const Row uneven = timed({10, 25, 20, 45}, 0.4);
    EXPECT_DOUBLE_EQ(change(four, uneven).half_width, confidence_half_width({0, 5, -10, 5}));
    EXPECT_TRUE(change_of(one, timed({11}, 0.4), M::wrong)->half_width == 0) << "numbers have no repeats";
}

/// How often, of 4000 times, the interval holds the mean of the normal numbers that the values were drawn from; each
/// value resembles the one before by `correlation`.
double held(std::size_t n, double correlation, Random& random) {
    constexpr int rounds = 4000;
    int held = 0;
    const auto normal = [&] {
        double sum = -6;
        for (int k = 0; k < 12; ++k) sum += random.unit();
        return sum;
    };
    for (int i = 0; i < rounds; ++i) {
        std::vector<double> values{normal()};
        while (values.size() < n)
            values.push_back(correlation * values.back() + std::sqrt(1 - correlation * correlation) * normal());
        double mean = 0;
        for (const double v : values) mean += v / static_cast<double>(n);
        held += std::abs(mean) <= confidence_half_width(values);
    }
    return held / static_cast<double>(rounds);
}

TEST(LabCompare, IntervalsHoldTheMeanNineteenTimesInTwenty) {
    Random random(81);
    for (const std::size_t n : {2u, 5u, 40u}) EXPECT_NEAR(held(n, 0, random), 0.95, 0.02) << n;
    // Frames of a path: without their likeness the intervals would hold it half of the time.
    EXPECT_GT(held(300, 0.8, random), 0.9);
    EXPECT_GT(held(100, 0.5, random), 0.9);
    EXPECT_EQ(confidence_half_width({3}), 0);
}

TEST(LabCompare, MatchesRows) {
    const Results a{{}, {row_of("layers", 1, {0.1}), row_of("published", 1, {0.2})}};
    const Results b{{}, {row_of("published", 2, {0.3}), row_of("layers", 2, {0.1})}};
    const auto by_method = compare_results(a, b);
    ASSERT_EQ(by_method.size(), 2u);
    EXPECT_EQ(by_method[0].b, &b.rows[1]);
    const Results only{{}, {row_of("published", 2, {0.3})}};
    EXPECT_EQ(compare_results(Results{{}, {a.rows[0]}}, only).size(), 1u) << "one method each";
    EXPECT_EQ(compare_methods(a, parse_method("layers"), parse_method("published")).size(), 1u);
    EXPECT_THROW(compare_methods(a, parse_method("layers"), parse_method("centroid")), InputError);
    Results elsewhere = b;
    for (Row& row : elsewhere.rows) row.scene = "room";
    EXPECT_THROW(compare_results(a, elsewhere), InputError);
    Results whole = a;
    whole.rows.push_back(row_of("view", 1, {0}, 5, "unlimited"));
    whole.rows.back().approximate = false;
    EXPECT_EQ(compare_methods(whole, parse_method("layers"), parse_method("view")).size(), 1u)
        << "no budget stands beside every budget";
    whole.rows.push_back(row_of("centroid", 1, {0}, 5, "unlimited"));
    EXPECT_EQ(compare_methods(whole, parse_method("layers"), parse_method("centroid")).size(), 1u)
        << "nor does it where the method may miss, as an engine's own set";
}

TEST(LabCompare, TimesOfTwoRunsAreHeldAgainstWhatNoHeuristicTouches) {
    const auto run = [](double published, double everything) {
        Results results{conditions_here(study_json({}), ""), {}};
        const double jitter[] = {0.99, 1, 1.01, 1};
        for (const auto& [method, ms] : {std::pair("published", published), std::pair("everything", everything)}) {
            results.rows.push_back(row_of(method, 1, {0.1, 0.2, 0.3, 0.1}));
            for (std::size_t i = 0; i < 4; ++i) results.rows.back().values[i][M::total_ms] = ms * jitter[i];
        }
        results.rows[1].approximate = false;
        results.rows[1].budget = "unlimited";
        return results;
    };
    const auto time_changed = [&](const Results& a, const Results& b) {
        const auto pairs = compare_results(a, b);
        for (const Change& change : pairs.front().changes)
            if (change.measure == M::total_ms) return change.significant();
        ADD_FAILURE();
        return false;
    };
    const Results before = run(10, 40), busy = run(12, 48), slower = run(12, 40);
    EXPECT_FALSE(time_changed(before, busy)) << "all times grew by a fifth";
    EXPECT_TRUE(time_changed(before, slower));
    Results with_boxes = before, faster_boxes = slower;
    for (Results* results : {&with_boxes, &faster_boxes}) {
        results->rows.push_back(results->rows.back());
        results->rows.back().method = parse_method("boxes");
    }
    for (Values& v : faster_boxes.rows.back().values) v[M::total_ms] /= 2;
    EXPECT_TRUE(time_changed(with_boxes, faster_boxes)) << "a conservative method that changed is no control";
    EXPECT_NEAR(*machine_change(compare_results(before, busy), "city", "test"), 0.2, 0.01);
    EXPECT_FALSE(machine_change(compare_results(before, busy), "room", "test"));
    Results alone = before, alone_busy = busy;
    alone.rows.pop_back();
    alone_busy.rows.pop_back();
    EXPECT_TRUE(time_changed(alone, alone_busy)) << "nothing says that it was the machine";

    const auto notes = [&](const Results& a, const Results& b) {
        std::string all;
        for (const std::string& note :
             notes_of({{"a", {}, a.conditions}, {"b", {}, b.conditions}, true, compare_results(a, b)}))
            all += note + "\n";
        return all;
    };
    EXPECT_NE(notes(before, busy).find("up to 20"), std::string::npos) << notes(before, busy);
    EXPECT_NE(notes(before, busy).find("0 of 2 numbers"), std::string::npos) << notes(before, busy);
    EXPECT_NE(notes(alone, alone_busy).find("look like a change"), std::string::npos);
    EXPECT_NE(notes(before, before).find("The same build"), std::string::npos);
    Results other = busy;
    other.conditions.program = "another";
    other.conditions.machine = "a slow one";
    EXPECT_NE(notes(before, other).find("Two builds"), std::string::npos);
    EXPECT_NE(notes(before, other).find("a slow one"), std::string::npos);
}

TEST(LabCompare, FailsWhereAskedTo) {
    const auto lines = [](const std::string& condition, const Row& a, const Row& b) {
        const Results x{{}, {a}}, y{{}, {b}};
        return failures(parse_fail_if(condition), compare_results(x, y));
    };
    const Row a = row_of("layers", 1, {0.10, 0.20}), b = row_of("layers", 1, {0.11, 0.20});  // 0.5 points worse
    EXPECT_TRUE(lines("wrong worse than 0.5 %", a, a).empty());
    EXPECT_TRUE(lines("wrong worse than 0.51 %", a, b).empty());
    EXPECT_TRUE(lines("wrong worse than 0 %", b, a).empty()) << "it got better";
    ASSERT_EQ(lines("wrong worse than 0.49 %", a, b).size(), 1u);
    EXPECT_EQ(lines("wrong worse than 0.49 %", a, b).front(),
              "city, path test, layers at 5%: wrong pixels 15 -> 15.5 % (+0.5 ± 6.35): within the noise")
        << "but the frames are the same, so it is no chance";
    EXPECT_EQ(lines("wrong  worse than .0049", a, b).size(), 1u) << "without a unit it is a share of 1";
    EXPECT_EQ(lines("coverage worse than 0.49%", a, b).size(), 1u);
    EXPECT_TRUE(lines("coverage worse than 0 %", b, a).empty());

    Row slow = row_of("layers", 1, {0.1, 0.1}, 11), fast = row_of("layers", 1, {0.1, 0.1}, 10);
    EXPECT_EQ(lines("time worse than 9 %", fast, slow).size(), 1u) << "of A's";
    EXPECT_TRUE(lines("time worse than 11 %", fast, slow).empty());
    EXPECT_EQ(lines("total_ms worse than 0.9 ms", fast, slow).size(), 1u);
    EXPECT_TRUE(lines("total_ms worse than 1.1", fast, slow).empty());
    for (Values& v : slow.values) v[M::total_error] = v[M::total_ms];
    for (Values& v : fast.values) v[M::total_error] = v[M::total_ms];
    EXPECT_TRUE(lines("time worse than 0 %", fast, slow).empty()) << "less than the repeats differ by";

    for (const char* wrong :
         {"", "wrong", "wrong worse 0.5", "wrong worse than", "wrong worse than x %", "wrong worse than -1 %",
          "wrong worse than nan", "wrong worse than 1 ms", "time worse than 1 s", "rendered worse than 1 %",
          "nosuch worse than 1 %", "wrong worse than 1 % or so", "wrong better than 1 %"})
        EXPECT_THROW(parse_fail_if(wrong), InputError) << wrong;
    EXPECT_THROW(lines("pop worse than 1 %", a, b), InputError) << "neither has it: nothing was compared";
}

TEST(LabCells, TheKneeIsTheCoarsestThatWillDo) {
    CellsCurve curve{"city", "test", parse_method("layers"), "5%", {}};
    const double wrong[] = {0.30, 0.115, 0.13, 0.105, 0.1};
    const std::uint32_t cells[] = {10, 50, 100, 500, 900};
    for (std::size_t i = 0; i < 5; ++i)
        curve.points.push_back({0.5 / double(i + 1), row_of("layers", cells[i], {wrong[i]})});
    EXPECT_EQ(knee(curve, M::wrong, 0), 4u);
    EXPECT_EQ(knee(curve, M::wrong, 0.006), 3u);
    EXPECT_EQ(knee(curve, M::wrong, 0.02), 1u) << "although the next finer one is worse";
    EXPECT_EQ(knee(curve, M::coverage, 0.02), 1u);
    EXPECT_EQ(knee(curve, M::wrong, 1), 0u);
    EXPECT_EQ(knee_text(curve, 0), "10 cells, the coarsest tried");
    EXPECT_EQ(knee_text(curve, 1), "50 cells");
    const auto settings = read_settings(knee_settings(curve, M::wrong, 0.02), "knee");
    EXPECT_EQ(settings,
              (std::vector<std::string>{"method=layers", "budget=5%", "tessellation=delaunay", "error_bound=0.25"}));
}

TEST(LabCells, TheCoarsestOfAllKindsIsWithinOfTheBestOfAll) {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        std::vector<CellsCurve> curves;
        for (const char* method : {"layers", "layers@tree", "layers@kd", "published"}) {
            curves.push_back({"city", "test", parse_method(method), "5%", {}, round % 2 ? "split_for=opacity" : ""});
            for (std::size_t i = 1 + random.below(5); i > 0; --i)
                curves.back().points.push_back(
                    {0.1, row_of(method, 1 + random.below(1000), {random.uniform(0, 0.05)})});
        }
        const double within = random.uniform(0, 0.02);
        const CurvePoint found = coarsest(curves, curves[1], M::wrong, within);
        ASSERT_LT(found.curve, 3u) << "another method is not asked";
        const auto wrong = [](const Row& row) { return summary(row, M::wrong); };
        double best = 1;
        for (std::size_t c = 0; c < 3; ++c)
            for (const CellsPoint& point : curves[c].points) best = std::min(best, wrong(point.row));
        const Row& taken = curves[found.curve].points[found.point].row;
        EXPECT_LE(wrong(taken), best + within);
        for (std::size_t c = 0; c < 3; ++c)
            for (const CellsPoint& point : curves[c].points)
                EXPECT_FALSE(wrong(point.row) <= best + within && point.row.cells < taken.cells);
    }
}

TEST(LabCells, KindsAreStudiesOfTheirOwn) {
    EXPECT_EQ(parse_kinds({"all"}).size(), 7u);
    EXPECT_EQ(parse_kinds({"kd+opacity"}), (std::vector<CellsKind>{{Tessellation::kd, "split_for=opacity"}}));
    for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
             {"moss"}, {"tree", "tree"}, {"tree+merge"}, {"all", "tree"}, {"+opacity"}})
        EXPECT_THROW(parse_kinds(wrong), InputError);
    Study sweep;
    sweep.methods = {parse_method("published@kd"), parse_method("published"), parse_method("layers")};
    sweep.settings = {"jitter=0.1"};
    const auto studies = kind_studies(sweep, parse_kinds({"tree", "kd+opacity", "tree+opacity", "delaunay"}));
    ASSERT_EQ(studies.size(), 2u);
    EXPECT_EQ(studies[0].study.methods, (std::vector{parse_method("published@tree"), parse_method("layers@tree"),
                                                     parse_method("published"), parse_method("layers")}));
    EXPECT_EQ(studies[0].study.settings, (std::vector<std::string>{"jitter=0.1"}));
    EXPECT_EQ(studies[1].study.methods, (std::vector{parse_method("published@kd"), parse_method("layers@kd"),
                                                     parse_method("published@tree"), parse_method("layers@tree")}));
    EXPECT_EQ(studies[1].study.settings, (std::vector<std::string>{"jitter=0.1", "split_for=opacity"}));
    sweep.settings = {"split_for=opacity"};
    EXPECT_THROW(kind_studies(sweep, parse_kinds({"tree+opacity"})), InputError);
    CellsCurve curve{"city", "test", parse_method("layers@tree"), "5%", {}, "split_for=opacity"};
    curve.points.push_back({0.25, row_of("layers@tree", 9, {0.1})});
    EXPECT_EQ(kind_text(curve, 0), "tree, split_for=opacity, error bound 0.25");
    EXPECT_EQ(read_settings(knee_settings(curve, M::wrong, 0), "knee").back(), "split_for=opacity");
}

TEST(LabCells, CurvesGoFromCoarseToFine) {
    Study study;
    study.methods = {parse_method("view"), parse_method("layers"), parse_method("centroid")};
    study = sweep_study(study, {0.1, 0.4, 0.1, 0.2});
    EXPECT_EQ(study.methods, std::vector{parse_method("layers")}) << "the others need no cells";
    EXPECT_EQ(study.error_bounds, (std::vector{0.4, 0.2, 0.1}));
    Results results;
    for (const double bound : study.error_bounds)
        for (const char* budget : {"1%", "5%"}) {
            results.rows.push_back(row_of("layers", 7, {bound}, 1, budget));
            results.rows.back().error_bound = bound;
        }
    const std::vector<CellsCurve> curves = curves_of(results);
    ASSERT_EQ(curves.size(), 2u);
    for (const CellsCurve& curve : curves) {
        ASSERT_EQ(curve.points.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(curve.points[i].error_bound, study.error_bounds[i]);
            EXPECT_EQ(curve.points[i].row.budget, curve.budget);
            EXPECT_EQ(curve.points[i].row.values[0][M::wrong], study.error_bounds[i]);
        }
    }
}

TEST(LabCells, TheSimplestMethodThatWillDo) {
    const std::vector<Row> rows{row_of("published", 1, {0.01}, 1), row_of("layers", 1, {0.05}, 2),
                                row_of("layers@tree", 1, {0.04}, 1.5), row_of("centroid", 1, {0.2}, 1)};
    std::vector<const Row*> all;
    for (const Row& row : rows) all.push_back(&row);
    EXPECT_EQ(simplest(all, M::wrong, 0.3), &rows[3]);
    EXPECT_EQ(simplest(all, M::wrong, 0.1), &rows[2]) << "as simple as the other, and faster";
    EXPECT_EQ(simplest(all, M::wrong, 0.02), &rows[0]);
    const Row few = row_of("layers", 50, {0.05}, 9), many = row_of("layers", 900, {0.04}, 2);
    EXPECT_EQ(simplest({&many, &few}, M::wrong, 0.1), &few) << "slower, but with fewer cells";
    EXPECT_EQ(simplest({&many, &few}, M::wrong, 0.045), &many);
    EXPECT_EQ(simplest(all, M::wrong, 0.001), nullptr);
    EXPECT_EQ(simplest(all, M::coverage, 0.955), &rows[2]);
    std::set<std::size_t> places;
    for (const Method<3>& method : method_table<3>()) places.insert(complexity({std::string(method.id), {}}));
    EXPECT_EQ(places.size(), method_table<3>().size()) << "two methods are equally simple";
}

TEST(LabReduce, FindsWhatCannotBeTakenAway) {
    Random random(82);
    for (int round = 0; round < 100; ++round) {
        const auto count = static_cast<std::uint32_t>(1 + random.below(60));
        std::set<std::uint32_t> needed;
        for (std::size_t i = random.below(5); i-- > 0;) needed.insert(static_cast<std::uint32_t>(random.below(count)));
        if (needed.empty()) needed.insert(0);
        int asked = 0;
        const auto kept = reduce(count, [&](std::span<const std::uint32_t> set) {
            ++asked;
            EXPECT_TRUE(std::is_sorted(set.begin(), set.end()));
            return std::includes(set.begin(), set.end(), needed.begin(), needed.end());
        });
        EXPECT_EQ(std::set<std::uint32_t>(kept.begin(), kept.end()), needed);
        EXPECT_LT(asked, 10 * 64);
    }
    EXPECT_THROW(reduce(5, [](auto) { return false; }), InputError);
    // Something that any three primitives show.
    EXPECT_EQ(reduce(50, [](std::span<const std::uint32_t> set) { return set.size() >= 3; }).size(), 3u);
    // Stopped, it keeps what it has.
    EXPECT_EQ(reduce(
                  64, [](auto set) { return !set.empty(); }, [](const ReduceProgress& at) { return at.left > 16; })
                  .size(),
              16u);
}

TEST(LabReduce, ShrinksAScene) {
    Study study;
    study.scenes = {"2d:rooms"};
    const LabScene<2> lab = load_lab_scene<2>("2d:rooms", "start", study);
    const MethodChoice method = parse_method("published");
    const Budget budget = parse_budget("400");
    const auto count = static_cast<std::uint32_t>(lab.scene->primitives.size());
    const auto holds = holds_in<2>(lab, method, budget, {"inversion == 1 && hidden_now > 2", ""}, {});
    const auto kept = reduce(count, holds);
    EXPECT_LT(kept.size(), count / 20);
    EXPECT_TRUE(holds(kept));
    for (std::size_t i = 0; i < kept.size(); ++i) {
        auto without = kept;
        without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_FALSE(holds(without)) << "primitive " << i << " could go";
    }
    const auto covered = holds_in<2>(lab, method, parse_budget("3"), {"", "coverage < 0.5 && visible > 6"}, {});
    const auto few = reduce(count, covered);
    EXPECT_EQ(few.size(), 7u) << "seven visible ones, of which three are rendered";
    EXPECT_THROW(holds_in<2>(lab, method, budget, {"", ""}, {}), InputError);
    EXPECT_THROW(holds_in<2>(lab, method, budget, {"", "total_ms > 1"}, {}), InputError);
    EXPECT_THROW(holds_in<2>(lab, method, budget, {"", "covrage > 1"}, {}), InputError);
}

TEST(SettingsFile, ReadsWhatItWrites) {
    const std::vector<std::string> assignments{"method=layers", "error_bound=0.07", "budget=2%"};
    EXPECT_EQ(read_settings(write_settings(assignments, "because \"so\""), "f"), assignments);
    for (const char* bad : {"", "[]", "{}", R"({"format": "sightline-settings", "version": 2, "settings": {}})",
                            R"({"format": "sightline-settings", "version": 1})",
                            R"({"format": "sightline-settings", "version": 1, "settings": {"error_bound": "7"}})",
                            R"({"format": "sightline-settings", "version": 1, "settings": {"no_such": "7"}})",
                            R"({"format": "sightline-settings", "version": 1, "settings": {"error_bound": [1]}})"})
        EXPECT_THROW(read_settings(bad, "bad.json"), InputError) << bad;
}

TEST(StudyJson, ReadsWhatItWrites) {
    Study study;
    study.scenes = {"city:50k", "2d:rooms"};
    study.paths = {"street", "a path.json"};
    study.frames = 7;
    study.methods = {parse_method("layers@tree")};
    study.budgets = {parse_budget("3%"), parse_budget("500")};
    study.size = {640, 480};
    study.settings = {"seeds=hull"};
    study.error_bounds = {0.4, 0.1};
    EXPECT_EQ(study_json(read_study(study_json(study))), study_json(study));
    EXPECT_EQ(study_json(read_study(study_json({}))), study_json({}));
    EXPECT_THROW(read_study("{}"), InputError);
}

/// Every command of the lab, with small arguments, as a person would type it.
TEST(LabCommands, Run) {
    const fs::path folder = fs::temp_directory_path() / ("sightline-commands-" + std::to_string(getpid()));
    const auto run = [&](const std::string& arguments, int expected) {
        fs::create_directories(folder);
        const fs::path said = folder / "said.txt";
        const std::string line = std::string(SIGHTLINE_LAB) + " " + arguments + " > " + said.string() + " 2>&1";
        const int status = std::system(line.c_str());
        EXPECT_EQ(WEXITSTATUS(status), expected) << arguments << "\n" << read_file(said);
    };
    const std::string small = " --frames 2 --size 160x120 --out " + folder.string();
    run("measure 3d:bottleneck 2d:rooms --repeats 1" + small + "/m", 0);
    run("measure 3d:bottleneck 2d:rooms --repeats 1" + small + "/m", 0);
    run("merge " + folder.string() + "/m --out " + folder.string() + "/merged", 0);
    run("stability 2d:rooms --samples 1 --methods layers" + small + "/s", 0);
    run("cells 3d:bottleneck --error-bounds 0.4,0.2 --repeats 0 --reach 0" + small + "/c", 0);
    run("measure 3d:bottleneck --repeats 0 --settings " + folder.string() + "/c/3d_bottleneck-layers-5_.settings.json" +
            small + "/m2",
        0);
    run("compare published layers 3d:bottleneck --budgets 5% --repeats 0" + small + "/d", 0);
    run("compare " + folder.string() + "/m " + folder.string() + "/m/results.json --out " + folder.string() + "/d2", 0);
    const std::string same =
        "compare " + folder.string() + "/m2 " + folder.string() + "/m2 --out " + folder.string() + "/d3";
    run(same + " --fail-if 'wrong worse than 0 %' --fail-if 'coverage worse than 0 %'", 0);
    run("compare published centroid 3d:bottleneck --budgets 5% --repeats 0 --fail-if 'flip worse than 0.1 %'" + small +
            "/d4",
        1);
    EXPECT_NE(read_file(folder / "said.txt").find("Failed: flip worse than 0.1 % (1 of 1 comparison)"),
              std::string::npos)
        << read_file(folder / "said.txt");
    run(same + " --fail-if 'time worse than 5 %'", 2);  // not timed
    run("reduce 3d:bottleneck --until 'inversion == 1' --out " + folder.string() + "/r", 0);
    for (const char* file : {"m/report.html", "m/results.csv", "merged/report.html", "s/stability.html", "c/cells.html",
                             "d/compare.html", "d2/compare.json", "r/reduced.json", "r/reduced.obj"})
        EXPECT_TRUE(fs::exists(folder / file)) << file;
    const auto results = read_results(read_file(folder / "m2/results.json"), "m2");
    ASSERT_EQ(results.rows.size(), 3u) << "method and budget are those of the settings file; and what to compare with";
    EXPECT_EQ(results.rows[1].method.id() + results.rows[2].method.id(), "viewperfect");
    EXPECT_EQ(results.rows[0].method.id(), "layers");
    EXPECT_EQ(load_results((folder / "c/without-cells").string()).rows.size(), 2u) << "centroid and view";
    EXPECT_EQ(load_results((folder / "c").string()).rows.size(), 4u);

    run("", 2);
    run("--help", 0);
    for (const Command& command : commands()) run(std::string(command.id) + " --help", 0);
    for (const char* wrong :
         {"measure nosuchscene", "measure city --methods nosuch", "measure city --size 0x0",
          "measure city --path nosuch", "measure city --set nosuch=1", "mesure city", "compare published",
          "compare published layers city --fail-if 'wrong worse'", "compare published nosuch city",
          "compare a.json b.json", "merge nosuch.json", "cells city --measure nosuch", "cells city --error-bounds 7",
          "reduce city", "reduce city --until 'nosuch > 1'", "measure city --settings nosuch.json",
          "measure city --shard 3/2", "stability nosuchscene"})
        run(wrong + std::string(" --out ") + folder.string() + "/wrong", 2);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace sightline::lab
