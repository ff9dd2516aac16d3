// Stability: what must not change does not, what must change does, and a primitive keeps its identity.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/stability/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "lab/lab_graphics.h"
#include "lab/stability/stability_charts.h"
#include "lab/stability/stability_report.h"

namespace sightline::lab {
namespace {

std::vector<StabilityRow> rows_from(const std::string& scene) {
    Study study;
    study.scenes = {scene};
    study.size = {160, 120};
    study.frames = 2;
    study.budgets = {parse_budget("5%")};
    LabGraphics graphics;
    StabilityOptions options;
    options.repeats = 2;
    const DrawIds draw_ids = graphics.draw_ids();
    return parse_scene(scene).dimension == 2
               ? measure_stability<2>(load_lab_scene<2>(scene, "", study), study, options, draw_ids)
               : measure_stability<3>(load_lab_scene<3>(scene, "", study), study, options, draw_ids);
}

bool power_of_two(double x) {
    int exponent = 0;
    return std::frexp(x, &exponent) == 0.5;
}

void expect_stable(const std::vector<StabilityRow>& rows) {
    bool jitter_matters = false, order_matters = false;
    for (const StabilityRow& row : rows) {
        const std::string where = row.scene + " " + method_text(row.method) + " " +
                                  std::string(disturbance_words[static_cast<std::size_t>(row.disturbance)]) + " " +
                                  std::to_string(row.amount);
        EXPECT_EQ(row.not_finite, 0u) << where;
        EXPECT_GE(row.jaccard, row.jaccard_min) << where;
        EXPECT_GE(row.jaccard_min, 0) << where;
        EXPECT_LE(row.jaccard, 1) << where;
        const bool tree = row.method.tessellation == Tessellation::tree;
        switch (row.disturbance) {
            case Disturbance::eye:
                EXPECT_EQ(row.samples, 4u) << where;
                break;
            case Disturbance::shuffle:
                // Cells are the same; inside a cell primitives come in another order, so that the cut cell differs.
                EXPECT_GT(row.jaccard, 0.6) << where;
                order_matters |= !row.equal;
                break;
            case Disturbance::scale:
                // Other factors round, which decides ties among cells on a grid.
                EXPECT_TRUE(row.equal || !power_of_two(row.amount)) << where;
                EXPECT_GT(row.jaccard, 0.5) << where;
                break;
            case Disturbance::offset:
                EXPECT_GT(row.jaccard, 0.9) << where;
                break;
            case Disturbance::jitter:
                EXPECT_TRUE(row.equal || !tree) << where << ": leaves are not jittered";
                jitter_matters |= !row.equal;
                break;
            case Disturbance::grazing:
                EXPECT_EQ(row.samples, 20u) << where;
                EXPECT_EQ(row.sweep.size(), 20u) << where;
                break;
        }
    }
    EXPECT_TRUE(jitter_matters) << "else other seeds were not tried";
    EXPECT_TRUE(order_matters) << "else nothing was shuffled";
    const auto count = [&](Disturbance d) {
        return std::count_if(rows.begin(), rows.end(), [&](const StabilityRow& r) { return r.disturbance == d; });
    };
    const auto methods = count(Disturbance::shuffle);
    EXPECT_EQ(methods, 12) << "the approximate ones";
    EXPECT_EQ(count(Disturbance::eye), 8 * methods);
    EXPECT_EQ(count(Disturbance::scale), 6 * methods);
    EXPECT_EQ(count(Disturbance::grazing), methods);
}

TEST(LabStability, IsMeasuredInBothDimensions) {
    expect_stable(rows_from("2d:rooms"));
    expect_stable(rows_from("city:10k"));
}

TEST(LabStability, ComparesEachPrimitiveWithItself) {
    // Sorted by distance the order does not depend on ids but for ties: the same triangles in any order of the file.
    for (const StabilityRow& row : rows_from("jungle:10k"))
        if (row.disturbance == Disturbance::shuffle && row.method.id() == "centroid") {
            EXPECT_DOUBLE_EQ(row.jaccard, 1);
            EXPECT_DOUBLE_EQ(row.coverage_change, 0);
        }
}

TEST(LabStability, IsTheSameTwiceAndWritten) {
    const std::vector<StabilityRow> rows = rows_from("2d:bottleneck");
    EXPECT_EQ(stability_csv(rows), stability_csv(rows_from("2d:bottleneck")));
    const std::string csv = stability_csv(rows);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), rows.size() + 1);
    const auto json = nlohmann::json::parse(stability_json(conditions_here("{}", ""), rows));
    ASSERT_EQ(json.at("rows").size(), rows.size());
    EXPECT_EQ(json.at("rows").at(0).at("jaccard"), rows.front().jaccard);
}

TEST(LabStability, ChartsShowWhatTheRowsSay) {
    std::vector<StabilityRow> rows;
    Results along_path;
    for (const char* method : {"published", "layers@tree"})
        for (const char* budget : {"5%", "10%"}) {
            StabilityRow row;
            row.scene = "city";
            row.path = "test";
            row.method = parse_method(method);
            row.budget = budget;
            row.amount = 1e-3;
            row.jaccard = 0.9;
            row.visible_jaccard = 0.8;
            row.coverage_change = 0.3;
            rows.push_back(row);
            row.disturbance = Disturbance::grazing;
            row.amount = 0.1;
            row.sweep = {0.5, 0.6, 0.7};
            rows.push_back(row);
            Row path;
            path.scene = "city";
            path.path = "test";
            path.method = row.method;
            path.budget = budget;
            path.frames = {0, 4};
            path.values.resize(2);
            path.values[1][Measure::pop] = 0.25;
            path.values[1][Measure::visible_change] = 0.125;
            along_path.rows.push_back(path);
        }
    const auto groups = stability_groups(rows);
    ASSERT_EQ(groups.size(), 2u);
    using Points = std::vector<std::array<double, 2>>;
    for (const StabilityGroup& group : groups) {
        EXPECT_EQ(group.rows.size(), 4u);
        const auto charts = stability_charts(group, along_path);
        ASSERT_EQ(charts.size(), 4u);
        const auto expect = [&](std::size_t i, const char* id, const Points& lines, const Points& grey) {
            const Chart& chart = charts[i].chart;
            EXPECT_NE(charts[i].id.find(id), std::string::npos);
            ASSERT_EQ(chart.series.size(), grey.empty() ? 2u : 3u) << id;
            for (std::size_t line = 0; line < 2; ++line) {
                ASSERT_EQ(chart.series[line].points.size(), lines.size()) << id;
                for (std::size_t p = 0; p < lines.size(); ++p)
                    for (std::size_t k = 0; k < 2; ++k)
                        EXPECT_NEAR(chart.series[line].points[p][k], lines[p][k], 1e-12) << id;
            }
            EXPECT_EQ(chart.series[1].name, "layers@tree");
            if (grey.empty()) return;
            EXPECT_NEAR(chart.series[2].points.at(0)[1], grey[0][1], 1e-12) << id;
        };
        expect(0, "rendered", {{1e-3, 10}}, {{1e-3, 20}});
        expect(1, "coverage", {{1e-3, 30}}, {});
        expect(2, "grazing", {{0.8, 50}, {0.9, 60}, {1, 70}}, {});
        expect(3, "path", {{4, 25}}, {{4, 12.5}});
    }
    EXPECT_EQ(stability_charts(groups[0], {}).size(), 3u) << "no path, no curve";
}

TEST(LabStability, StagesDoNotDependOnWhichOthersRan) {
    Study study;
    study.scenes = {"2d:rooms"};
    study.frames = 2;
    study.methods = {parse_method("published"), parse_method("layers@tree")};
    study.budgets = {parse_budget("5%"), parse_budget("10%")};
    const LabScene<2> lab = load_lab_scene<2>("2d:rooms", "", study);
    std::map<std::string, std::string> kept;
    double shares = 0;
    StabilityWatch watch;
    watch.stage_done = [&](const StabilityStage& stage) {
        shares += stage.share;
        EXPECT_EQ(stage.rows.size(), 4u) << stage.name;
        EXPECT_TRUE(kept.emplace(stage.name, stability_rows_json(stage.rows)).second) << stage.name << " comes twice";
        return true;
    };
    const std::vector<StabilityRow> whole = measure_stability<2>(lab, study, {}, {}, watch);
    EXPECT_NEAR(shares, 1, 1e-12);
    // Stopped after three stages, going on with what was kept.
    int stages = 0;
    StabilityWatch stopping;
    stopping.stage_done = [&](const StabilityStage&) { return ++stages < 3; };
    EXPECT_EQ(measure_stability<2>(lab, study, {}, {}, stopping).size(), 3u * 4);
    int measured = 0;
    StabilityWatch going_on;
    going_on.finished = [&](const std::string& stage) -> std::optional<std::vector<StabilityRow>> {
        if (++measured % 2 == 0) return std::nullopt;  // every other one again
        return read_stability_rows(kept.at(stage));
    };
    EXPECT_EQ(stability_csv(measure_stability<2>(lab, study, {}, {}, going_on)), stability_csv(whole));
}

}  // namespace
}  // namespace sightline::lab
