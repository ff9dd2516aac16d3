// What the lab measures of culling in object space, and sweeps of a parameter.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/truth/software_ids.h"
#include "lab/cells/sweep.h"
#include "lab/object_space/object_space_report.h"
#include "lab/object_space/papers_scenes.h"
#include "tests/lab/report_rows.h"
#include "tests/lab/run_lab.h"

namespace sightline::lab {
namespace {

namespace fs = std::filesystem;
using M = Measure;

/// A wall between the eye and five small triangles, of which one stands beside it; a sixth looks away from the eye.
SeededScene wall_scene() {
    auto scene = std::make_shared<Scene<3>>();
    const auto add = [&](double x, double y, double side, double turned) {
        scene->primitives.push_back({Vec<3>(x, y, -side), Vec<3>(x, y + turned * side, -side), Vec<3>(x, y, side)});
    };
    // Seen from x = 0 towards +x the corners turn counter-clockwise.
    scene->primitives.push_back({Vec<3>(1, -2, -2), Vec<3>(1, -2, 2), Vec<3>(1, 2, -2)});
    scene->primitives.push_back({Vec<3>(1, 2, 2), Vec<3>(1, 2, -2), Vec<3>(1, -2, 2)});
    for (const double y : {-0.8, -0.4, 0.2, 0.6}) add(4 + y, y, 0.1, -1);
    add(1, 2.6, 0.1, -1);
    add(1, -2.6, 0.1, 1);
    FlightPath<3> walk{"walk", {}, {}, {}};
    for (int i = 0; i < 5; ++i) walk.frames.push_back({{-1, 0.01 * i, 0}, {1, 0.01 * i, 0}, 60});
    scene->paths = {walk};
    scene->paths.push_back(walk);
    scene->paths.back().id = "line";
    return {"wall", 1, scene};
}

ObjectSpaceOptions small_options() {
    ObjectSpaceOptions options;
    options.repeats = 1;
    options.face = {128, 128};
    options.speeds = {1, 2};
    options.workers = {1, 2};
    options.parallel = "coorg-teller leaf=1 tree=octree coherence=off";
    return options;
}

TEST(ObjectSpace, CountsWhatIsCulledOfWhatCannotBeSeen) {
    const std::vector<AllRound> rows = measure_all_round(
        wall_scene(),
        {"coorg-teller leaf=1 tree=octree", "coorg-teller leaf=100 tree=octree", "coorg-teller threshold=100"},
        &draw_ids_in_software, small_options());
    ASSERT_EQ(rows.size(), 3u);
    const Culled& fine = rows[0].culled;
    // In each of five frames four behind the wall, and one that looks away; the wall's two triangles are one polygon.
    EXPECT_EQ(fine.invisible, 25u);
    EXPECT_EQ(fine.invisible_primitives, 25u);
    EXPECT_EQ(fine.facing, 20u);
    EXPECT_EQ(fine.culled, 20u) << "its box is drawn where a triangle looks away";
    EXPECT_EQ(fine.not_drawn, 25u);
    EXPECT_DOUBLE_EQ(fine.share(), 0.8);
    EXPECT_DOUBLE_EQ(fine.not_drawn_share(), 1);
    EXPECT_DOUBLE_EQ(fine.facing_share(), 1);
    EXPECT_EQ(rows[1].culled.culled, 0u) << "one box";
    EXPECT_EQ(rows[2].culled.culled, 0u) << "no occluder is large enough";
    EXPECT_EQ(rows[2].cost.occluders, 0);
    for (const AllRound& row : rows) {
        EXPECT_EQ(row.culled.missed, 0u);
        EXPECT_EQ(row.cost.frames, 4u) << "the first pays for all that is new";
    }
    EXPECT_EQ(rows[0].cost.drawn, 3);
    EXPECT_GT(rows[0].cost.boxes, rows[1].cost.boxes);
    EXPECT_DOUBLE_EQ(rows[0].cost.tested_each(), rows[0].cost.tested / rows[0].cost.occluders);
    EXPECT_THROW(measure_all_round(wall_scene(), {"view"}, &draw_ids_in_software, small_options()), InputError);
}

/// A reference that shows a triangle behind the wall: what is missed is told, with its pixels.
TEST(ObjectSpace, TellsWhatIsMissed) {
    const DrawIds wrong = [](const Scene<3>&, const View<3>&, const ImageSize&, int) {
        return std::vector<IdImage>{{2, 1, {3, none}}};
    };
    const auto rows = measure_all_round(wall_scene(), {"coorg-teller leaf=1 tree=octree"}, wrong, small_options());
    EXPECT_EQ(rows[0].culled.missed, 5u);
    EXPECT_EQ(rows[0].culled.missed_pixels, 30u) << "six images in five frames";
}

TEST(ObjectSpace, KeepsLessTheFasterTheEye) {
    const auto rows = measure_speeds(wall_scene(), "coorg-teller leaf=1 tree=octree", small_options());
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].keeping.frames, 4u);
    EXPECT_EQ(rows[1].keeping.frames, 2u);
    EXPECT_GT(rows[0].keeping.kept, 0);
    EXPECT_EQ(rows[0].fresh.kept, 0);
    EXPECT_LT(rows[0].keeping.products, rows[0].fresh.products);
    EXPECT_EQ(rows[0].keeping.boxes, rows[0].fresh.boxes);
    EXPECT_EQ(rows[0].keeping.drawn, rows[0].fresh.drawn);
}

TEST(ObjectSpace, CountsTheSameWithAnyNumberOfThreads) {
    const auto rows = measure_workers(wall_scene(), small_options());
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[1].workers, 2);
    EXPECT_EQ(rows[0].cost.tested, rows[1].cost.tested);
    EXPECT_EQ(rows[0].cost.products, rows[1].cost.products);
    EXPECT_EQ(rows[0].cost.drawn, rows[1].cost.drawn);
    EXPECT_GT(rows[0].cost.products, 0);
}

TEST(ObjectSpace, LooksAtLessInAView) {
    SeededScene scene = wall_scene();
    auto turned = std::make_shared<Scene<3>>(*scene.scene);
    for (ViewSpec<3>& frame : turned->paths[0].frames) frame.look_at = frame.eye + Vec<3>(-1, 0, 0);
    scene.scene = turned;
    const TimeDrawing draw = [](const std::shared_ptr<const Scene<3>>&, const View<3>&,
                                std::span<const std::uint32_t>) {
        return DrawTimes{1, 2};
    };
    const auto rows = measure_in_view(scene, {"view", "coorg-teller leaf=1 tree=octree"}, draw, small_options());
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[1].cost.drawn, 0) << "all is behind the eye";
    EXPECT_LE(rows[1].cost.boxes, 1) << "others are switched off before they are asked for";
    EXPECT_GT(rows[1].all_round.boxes, 4);
    EXPECT_DOUBLE_EQ(rows[1].draw_ms, 3);
    EXPECT_NEAR(hidden_ms(rows[0], rows[1]), rows[0].cost.cull_ms(), 1e-9);
}

TEST(ObjectSpace, BuildsBothTrees) {
    const Construction kd = measure_construction(wall_scene(), "kd", small_options()),
                       octree = measure_construction(wall_scene(), "octree", small_options());
    for (const Construction& made : {kd, octree}) {
        EXPECT_EQ(made.primitives, 8u);
        EXPECT_EQ(made.polygons, 7u);
        EXPECT_GE(made.references, 7u);
        EXPECT_GT(made.first_frame_ms, 0);
    }
}

/// Results made by hand.
ObjectSpaceResults results_by_hand() {
    ObjectSpaceResults results;
    results.conditions = conditions_here(R"({"scenes": ["soda"]})", "");
    ObjectSpaceScene scene;
    scene.name = "soda";
    scene.seeds = {1, 2};
    scene.construction = {{"kd", 3400, 1700, 3400, 1000, 5, 10, 0.5, 0.25}};
    WalkCost single{.frames = 10, .occluders_ms = 0.1, .visible_ms = 0.2, .occluders = 32, .boxes = 300};
    single.tested = 64;
    WalkCost several = single;
    several.visible_ms = 0.15;
    Culled less{.invisible = 100, .culled = 70}, more{.invisible = 100, .culled = 74};
    Culled most = more;
    most.culled = 80;
    scene.all_round = {{{"coorg-teller", single, less}, {"coorg-teller connected=on", several, more}},
                       {{"coorg-teller", single, less}, {"coorg-teller connected=on", several, most}}};
    WalkCost fast = single;
    fast.visible_ms = 0.8;
    scene.speeds = {{1, single, single}, {16, fast, fast}};
    WalkCost slow = single, half = single;
    slow.visible_ms = 3;
    half.visible_ms = 2;
    scene.workers = {{1, slow}, {2, half}};
    WalkCost view = single, in_view = several;
    view.occluders_ms = 0;
    in_view.visible_ms = 0.05;
    scene.in_view = {{"view", view, 2, view}, {"coorg-teller connected=on", in_view, 1, several}};
    results.scenes = {scene};
    return results;
}

std::string said_of(const ObjectSpaceResults& results, const std::string& words) {
    for (const Claim& claim : object_space_claims(results))
        if (claim.text.find(words) != std::string::npos) return claim.regimes[0].figures + ": " + verdict_text(claim);
    return "not judged";
}

TEST(ObjectSpaceTables, HaveThePapersRowsAboveOurs) {
    const std::vector<TitledTable> tables = object_space_tables(results_by_hand());
    ASSERT_EQ(tables.size(), 5u);
    EXPECT_EQ(tables[0].table.rows[0],
              (std::vector<std::string>{"Soda (the paper)", "kd", "–", "1685", "2971", "1.76", "–", "160", "510"}));
    EXPECT_EQ(tables[0].table.rows[1],
              (std::vector<std::string>{"soda", "kd", "3400", "1700", "3400", "2", "1000", "5 + 10", "0.5 + 0.25"}));
    const auto& culling = tables[1].table.rows;
    ASSERT_EQ(culling.size(), 4u);
    EXPECT_EQ(culling[1][5], ".75");
    EXPECT_EQ(culling[3][1], "coorg-teller connected=on");
    EXPECT_EQ(culling[3][3], "2") << "boxes tested per occluder";
    EXPECT_EQ(culling[3][5], ".77") << "the mean of two seeds";
    const std::string plain = plain_text(tables[3]);
    EXPECT_NE(plain.find("Table 4: threads\n"), std::string::npos);
    EXPECT_NE(plain.find("  soda              2          2            1.5"), std::string::npos) << plain;
    for (const TitledTable& table : tables)
        for (const auto& row : table.table.rows) EXPECT_EQ(row.size(), table.table.head.size()) << table.title;
    // The paper's speed-ups are as printed, and one of them is not what its times say.
    EXPECT_NEAR(papers_scene("tetra")->speedups[1], 1.55, 1e-9);
    EXPECT_NEAR(papers_scene("tetra")->workers[0] / papers_scene("tetra")->workers[1], 1.44, 0.005);
    EXPECT_EQ(papers_scene("soda:500k"), papers_scene("soda"));
    EXPECT_EQ(papers_scene("city"), nullptr);
}

TEST(ObjectSpaceClaims, AreJudged) {
    ObjectSpaceResults results = results_by_hand();
    EXPECT_EQ(said_of(results, "never culled"), "0 visible triangles missed, 0 pixels: holds");
    EXPECT_EQ(said_of(results, "It finds"), ".77 with coorg-teller connected=on, theirs .75: holds");
    EXPECT_EQ(said_of(results, "Connected"), "Cull .7 and .77, 0.2 and 0.15 ms: holds");
    EXPECT_EQ(said_of(results, "Switching off"), "3 times as fast, 1 times fewer boxes: does not hold");
    EXPECT_EQ(said_of(results, "At 16 times"), "4 times, theirs 3.59: does not hold");
    EXPECT_EQ(said_of(results, "Two processors"), "1.5 times as fast from 3 ms: holds");
    EXPECT_EQ(said_of(results, "interactive"),
              "0.15 ms, 0.13 of the 1.2 ms that view culling spends on what it hides: holds");
    results.scenes[0].all_round[1][0].culled.missed = 1;
    EXPECT_EQ(said_of(results, "never culled"), "1 visible triangles missed, 0 pixels: does not hold");
    results.scenes[0].workers[0].cost.visible_ms = 0.9;
    EXPECT_EQ(said_of(results, "Two processors"), "not judged") << "less than a millisecond";
    results.scenes[0].in_view[1].cost.visible_ms = 0.25;
    EXPECT_NE(said_of(results, "interactive").find("does not hold"), std::string::npos);
}

TEST(ObjectSpaceJson, HasTheTables) {
    const auto json = nlohmann::json::parse(object_space_json(results_by_hand()));
    EXPECT_EQ(json["format"], "sightline-object-space");
    EXPECT_EQ(json["conditions"]["study"]["scenes"][0], "soda");
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["construction"][0]["references"], 3400);
    EXPECT_EQ(scene["all_round"].size(), 4u);
    EXPECT_EQ(scene["all_round"][3]["seed"], 2);
    EXPECT_EQ(scene["all_round"][3]["cull"], 0.8);
    EXPECT_TRUE(scene["all_round"][3]["cull_of_front_faces"].is_null()) << "none turns its front";
    EXPECT_EQ(scene["speeds"][1]["speed"], 16);
    EXPECT_EQ(scene["threads"][1]["cost"]["visible_ms"], 2);
    EXPECT_EQ(scene["in_view"][1]["draw_ms"], 1);
    EXPECT_EQ(json["claims"].size(), 7u);
}

TEST(ObjectSpaceCommand, WritesItsPageAndNamesWhatIsWrong) {
    const fs::path folder = fs::temp_directory_path() / ("sightline-object-space-" + std::to_string(getpid()));
    const auto lab = [](const std::vector<std::string>& words) { return test::run_lab("object-space", words); };
    const auto [status, said] = lab({"tetra",
                                     "--walk",
                                     "test",
                                     "--line",
                                     "test",
                                     "--seeds",
                                     "2",
                                     "--frames",
                                     "2",
                                     "--repeats",
                                     "1",
                                     "--face",
                                     "64x64",
                                     "--methods",
                                     "coorg-teller; coorg-teller connected=on",
                                     "--large",
                                     "none",
                                     "--out",
                                     folder.string(),
                                     "--markdown",
                                     (folder / "page.md").string()});
    EXPECT_EQ(status, 0) << said;
    EXPECT_NE(said.find("Tetra (the paper)"), std::string::npos) << said;
    EXPECT_NE(said.find("holds: What is visible is never culled."), std::string::npos) << said;
    const auto json = nlohmann::json::parse(read_file(folder / "results.json"));
    EXPECT_EQ(json["scenes"].size(), 1u);
    EXPECT_EQ(json["scenes"][0]["seeds"].size(), 2u);
    EXPECT_NE(json["scenes"][0]["all_round"][0]["culled_polygons"],
              json["scenes"][0]["all_round"][2]["culled_polygons"])
        << "another seed is another scene";
    EXPECT_NE(read_file(folder / "object-space.html").find("Table 3"), std::string::npos);
    EXPECT_NE(read_file(folder / "page.md").find("## Table 2"), std::string::npos);
    fs::remove_all(folder);
    const auto complains = [&](const std::vector<std::string>& words, const std::string& of) {
        const auto [failed, text] = lab(words);
        EXPECT_EQ(failed, 2);
        EXPECT_NE(text.find(of), std::string::npos) << text;
    };
    complains({"soda", "--methods", "hzb"}, "does not cull in object space");
    complains({"soda", "--methods", "coorg-teller leaf=0"}, "leaf");
    complains({"soda:1"}, "is not a size");
    complains({"soda", "--walk", "moon", "--large", "none"}, "moon");
}

TEST(LabSweep, IsReadAsItIsWritten) {
    EXPECT_EQ(parse_sweep("occluder_count=8,16").parameter, "occluder_count");
    EXPECT_EQ(parse_sweep("tree=kd,octree").values, (std::vector<std::string>{"kd", "octree"}));
    for (const char* const text : {"", "leaf", "leaf=", "leaf=8", "leaf=8,,16", "=8,16", "leaf=8,16,"})
        EXPECT_THROW(parse_sweep(text), InputError) << text;
}

TEST(LabSweep, TakesEachMethodThatHasTheParameter) {
    Study study;
    study.methods = {parse_method("view"), parse_method("coorg-teller leaf=4 connected=on"),
                     parse_method("shadow-frusta")};
    const std::vector<Sweep> sweeps{parse_sweep("occluder_count=8,32"), parse_sweep("leaf=2,4")};
    const Study swept = parameter_study(study, sweeps);
    std::vector<std::string> variants;
    for (const MethodChoice& choice : swept.methods) variants.push_back(choice.variant);
    EXPECT_EQ(variants, (std::vector<std::string>{
                            "coorg-teller leaf=4 connected=on occluder_count=8",
                            "coorg-teller leaf=4 connected=on occluder_count=32", "coorg-teller connected=on leaf=2",
                            "coorg-teller connected=on leaf=4", "shadow-frusta leaf=2", "shadow-frusta leaf=4"}));
    EXPECT_THROW(parameter_study(study, {parse_sweep("on_reenqueue=min,max")}), InputError) << "none has it";
    EXPECT_THROW(parameter_study(study, {parse_sweep("leaf=2,none")}), InputError);

    Results results;
    double ms = 5;
    for (const MethodChoice& choice : swept.methods) {
        results.rows.push_back(test::report_row("soda", choice.variant, "unlimited", ms, 0, 1));
        ms -= ms > 3.5 ? 1 : -1;
    }
    const std::vector<SweepCurve> curves = sweep_curves(study, sweeps, results);
    ASSERT_EQ(curves.size(), 3u);
    EXPECT_EQ(curves[0].method.variant, "coorg-teller leaf=4 connected=on");
    EXPECT_EQ(curves[1].method.variant, "coorg-teller connected=on");
    EXPECT_EQ(curves[1].values, (std::vector<std::string>{"2", "4"}));
    EXPECT_EQ(best(curves[0], M::total_ms), 1u) << "5 and 4 ms";
    EXPECT_EQ(best(curves[1], M::total_ms), 0u) << "3 and 4 ms";
    EXPECT_EQ(best(curves[1], M::coverage), 0u) << "equal: the first";
    EXPECT_NE(sweep_settings(curves[0], M::total_ms).find("occluder_count=32"), std::string::npos);
}

TEST(LabSweep, HasAPageWithCharts) {
    Study study;
    study.methods = {parse_method("coorg-teller")};
    const std::vector<Sweep> sweeps{parse_sweep("leaf=2,4"), parse_sweep("tree=kd,octree")};
    Results results;
    for (const MethodChoice& choice : parameter_study(study, sweeps).methods)
        results.rows.push_back(test::report_row("soda", choice.variant, "unlimited", 1, 0, 1));
    const fs::path folder = fs::temp_directory_path() / ("sightline-sweep-" + std::to_string(getpid()));
    write_sweep_report(sweep_curves(study, sweeps, results), M::total_ms, folder);
    const std::string html = read_file(folder / "sweep.html");
    EXPECT_NE(html.find("leaf: soda, path test, budget unlimited"), std::string::npos);
    EXPECT_NE(html.find("octree"), std::string::npos);
    EXPECT_TRUE(fs::exists(folder / "charts" / "sweep-leaf-soda-test-unlimited-total_ms.svg"));
    fs::remove_all(folder);
}

}  // namespace
}  // namespace sightline::lab
