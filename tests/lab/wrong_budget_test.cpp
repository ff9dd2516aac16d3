// Budgets that follow the wrong pixels of the frames before: what they may know, what is counted, and reading it back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measure/wrong_budget.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/measure/frame_numbers.h"
#include "core/run/wrong_budget.h"
#include "core/truth/truth.h"
#include "lab/report/study_charts.h"
#include "lab/report/time_table.h"
#include "tests/lab/report_rows.h"

namespace sightline::lab {
namespace {

TEST(WrongBudget, FollowsWhatTheLastFramesNeeded) {
    NeededBudgets frames;
    EXPECT_EQ(predict_needed(frames, 1000), 1000u) << "nothing is known";
    note_needed(frames, 1000, 20);
    EXPECT_EQ(predict_needed(frames, 1000), 20u);
    note_needed(frames, 20, none);
    EXPECT_EQ(predict_needed(frames, 1000), 40u) << "it had too little";
    note_needed(frames, 0, none);
    EXPECT_EQ(predict_needed(frames, 30), 30u) << "there are no more";
    for (int i = 0; i < 8; ++i) note_needed(frames, 40, 5);
    EXPECT_EQ(predict_needed(frames, 1000), 5u) << "eight frames ago is forgotten";
    note_needed(frames, none - 1, none);
    EXPECT_EQ(predict_needed(frames, none), none - 1) << "no overflow";
}

TEST(WrongBudget, IsTheSmallestThatDoes) {
    const LabScene<2> lab = [] {
        Study study;
        study.methods = {{"published"}, {"centroid"}};
        return load_lab_scene<2>("rooms", "start", study);
    }();
    for (const char* method : {"published", "centroid"}) {
        const Variant<2> variant = lab.variant_for({method});
        const CellComplex<2>* const cells = &lab.on(Tessellation::delaunay);
        const Reference reference = make_reference(*lab.scene, *cells, lab.views[0], {}, {});
        const WholeRun run = whole_run<2>(
            variant.method, make_problem(variant.method, variant.parameters, *lab.scene, *cells, lab.views[0]),
            reference, false);
        const auto all = static_cast<std::uint32_t>(lab.scene->primitives.size());
        const auto wrong_at = [&](std::uint32_t budget) {
            return wrong_pixels(reference, std::span(run.met).first(cut_at(run, budget).met));
        };
        for (const double share : {0.0, 0.01, 0.1, 0.5}) {
            std::uint32_t smallest = 0;
            while (wrong_at(smallest) > share) ++smallest;
            EXPECT_EQ(needed_budget(run, reference, share, all), smallest) << method << ' ' << share;
            if (smallest > 0) {
                EXPECT_EQ(needed_budget(run, reference, share, smallest - 1), none);
            }
        }
    }
}

TEST(WrongBudget, IsFlownWithWhatTheFramesBeforeTell) {
    Study study;
    study.methods = {{"layers"}, {"view"}, {"perfect"}, {"published", Tessellation::tree}};
    study.wrong_budgets = {0.02, 0.2};
    const LabScene<2> lab = load_lab_scene<2>("rooms", "", study);
    const auto flights = fly_in_wrong_pixels(lab, study, {}, [] { return true; });
    ASSERT_EQ(flights.size(), 4u) << "two methods have budgets";
    const auto total = static_cast<std::uint32_t>(lab.scene->primitives.size());
    for (const WrongFlight& flight : flights) {
        ASSERT_EQ(flight.frames.size(), lab.views.size());
        NeededBudgets known;
        for (const WrongFrame& frame : flight.frames) {
            EXPECT_EQ(frame.budget, predict_needed(known, total));
            EXPECT_EQ(frame.wrong <= flight.wrong, frame.needed != none && frame.needed <= frame.budget);
            EXPECT_LE(frame.rendered, frame.budget);
            note_needed(known, frame.budget, frame.needed <= frame.budget ? frame.needed : none);
        }
    }
    EXPECT_LT(flights[1].frames.back().budget, flights[0].frames.back().budget) << "more may be wrong";
    EXPECT_TRUE(fly_in_wrong_pixels(lab, study, {}, [] { return false; }).empty());
    study.wrong_budgets.clear();
    EXPECT_TRUE(fly_in_wrong_pixels(lab, study, {}, [] { return true; }).empty());
}

WrongFlight made_by_hand() {
    return {"city",
            "test",
            parse_method("layers@tree"),
            0.005,
            {{1000, 1000, 0, 100}, {100, 90, 0.0054, 110}, {200, 190, 0.006, none}}};
}

TEST(WrongBudget, IsWrittenCountedAndReadBack) {
    const WrongFlight flight = made_by_hand();
    EXPECT_EQ(share_kept(flight), 0.5) << "the first frame does not count";
    EXPECT_TRUE(std::isnan(share_kept(WrongFlight{})));
    EXPECT_EQ(kept_text(flight), "50 % of " + std::to_string(flight.frames.size() - 1) +
                                     " frames (all but the first, which nothing is known of) within wrong:0.5% + 10 %");
    EXPECT_TRUE(kept_text(WrongFlight{}).starts_with("none of 0 frames"));
    const std::string text = wrong_flights_json({flight, {}});
    EXPECT_EQ(text.find('\n'), std::string::npos) << "a checkpoint is a line";
    const auto read = read_wrong_flights(text);
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].method, flight.method);
    EXPECT_EQ(read[0].frames[2].needed, none);
    EXPECT_EQ(wrong_flights_json(read), text);

    Results results = test::results_of({test::report_row("city", "layers@tree", "5%", 5, 0.2, 0.8)});
    results.wrong_flights = {flight};
    EXPECT_EQ(read_results(results_json(results, ""), "x").wrong_flights.size(), 1u);
    EXPECT_EQ(wrong_budget_table(results).rows.at(0).at(2), "wrong:0.5%");
    std::size_t charts = 0;
    for (const NamedChart& chart : study_charts(results)) {
        if (chart.id != "city-test-frames-wrong-budget") continue;
        ++charts;
        ASSERT_EQ(chart.chart.series.size(), 2u);
        EXPECT_EQ(chart.chart.series[0].points[1][1], 100);
        EXPECT_EQ(chart.chart.series[1].points[1][1], 110);
        EXPECT_TRUE(std::isnan(chart.chart.series[1].points[2][1])) << "none would do";
    }
    EXPECT_EQ(charts, 1u);

    EXPECT_EQ(parse_wrong_budget("wrong:0.5%"), 0.005);
    EXPECT_EQ(parse_wrong_budget("5%"), std::nullopt);
    for (const char* wrong : {"wrong:", "wrong:5", "wrong:x%", "wrong:-1%", "wrong:100%", "wrong:nan%"})
        EXPECT_THROW(parse_wrong_budget(wrong), InputError) << wrong;
    Study study;
    study.wrong_budgets = {0.005};
    EXPECT_EQ(study_json(read_study(study_json(study))), study_json(study));
    EXPECT_NE(study_json(study), study_json(Study{}));
}

}  // namespace
}  // namespace sightline::lab
