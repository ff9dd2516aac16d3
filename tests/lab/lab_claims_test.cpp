// What the papers say, judged on results made by hand: verdicts, on what they depend, and the papers' tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/claims.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/report/gem_table.h"
#include "lab/report/papers_tables.h"
#include "tests/lab/report_rows.h"

namespace sightline::lab {
namespace {

using test::report_row;
using test::results_of;
using M = Measure;

Row with(Row row, std::initializer_list<std::pair<M, double>> values) {
    for (Values& v : row.values)
        for (const auto& [measure, value] : values) v[measure] = value;
    return row;
}
Row along(Row row, const std::string& path) {
    row.path = path;
    return row;
}

/// The claim whose text has these words; nullptr when it is not judged.
const Claim* find(const std::vector<Claim>& claims, const std::string& words) {
    for (const Claim& claim : claims)
        if (claim.text.find(words) != std::string::npos) return &claim;
    return nullptr;
}
std::string judged(const std::vector<Row>& rows, const std::string& words) {
    const Results results = results_of(rows);
    const std::vector<Claim> claims = judge_claims(results);
    const Claim* claim = find(claims, words);
    return claim ? verdict_text(*claim) : "not judged";
}

TEST(LabClaims, HoldFailOrDepend) {
    // Coverage of published at 10 % by size and path; the claim is 90 %.
    const auto coverage = [](double small_street, double small_air, double large_street, double large_air) {
        const auto row = [](const char* scene, const char* path, double value) {
            return along(report_row(scene, "published", "10%", 9, 0, value), path);
        };
        return std::vector{row("city:100k", "street", small_street), row("city:100k", "air", small_air),
                           row("city:500k", "street", large_street), row("city:500k", "air", large_air)};
    };
    const char* words = "over 90 %";
    EXPECT_EQ(judged(coverage(0.95, 0.95, 0.95, 0.95), words), "holds");
    EXPECT_EQ(judged(coverage(0.5, 0.5, 0.5, 0.5), words), "does not hold");
    EXPECT_EQ(judged(coverage(0.95, 0.5, 0.95, 0.5), words), "depends (on path)");
    EXPECT_EQ(judged(coverage(0.5, 0.5, 0.95, 0.95), words), "depends (on size)");
    EXPECT_EQ(judged(coverage(0.95, 0.95, 0.95, 0.5), words), "depends (on path, on size)");
    EXPECT_EQ(judged({}, words), "not judged");
    // Only what differs in both disagrees.
    std::vector<Row> two = coverage(0.95, 0.5, 0.5, 0.5);
    two = {two[0], two[3]};
    EXPECT_EQ(judged(two, words), "depends (on path, on size)");

    const Results results = results_of(coverage(0.95, 0.5, 0.95, 0.5));
    const std::vector<Claim> claims = judge_claims(results);
    const Claim* claim = find(claims, words);
    ASSERT_TRUE(claim);
    ASSERT_EQ(claim->regimes.size(), 4u);
    EXPECT_EQ(regime_text(*claim, claim->regimes[0]), "city:100k, street: 95 % (holds)");
    EXPECT_EQ(regime_text(*claim, claim->regimes[3]), "city:500k, air: 50 % (does not hold)");
    EXPECT_EQ(row_to_show(*claim), &results.rows[1]) << "the first that does not hold";
    const auto json = nlohmann::json::parse(claims_json(claims));
    EXPECT_EQ(json[0]["verdict"], "depends (on path)");
    EXPECT_EQ(json[0]["regimes"][1]["holds"], false);
}

TEST(LabClaims, ThatScenesDisagreeOnDependOnTheScene) {
    const std::vector<Row> rows{report_row("city", "published", "1%", 9, 0, 0.5),
                                report_row("cars", "published", "1%", 9, 0, 0.3)};
    EXPECT_EQ(judged(rows, "over 40 %"), "depends (on scene)");
}

TEST(LabClaims, AboutSpeedAreJudgedAgainstViewCulling) {
    std::vector<Row> rows{report_row("cars", "published", "1%", 5, 0, 0.5),
                          report_row("cars", "everything", "unlimited", 55, 0, 1),
                          report_row("cars", "view", "unlimited", 45, 0, 1)};
    EXPECT_EQ(judged(rows, "more than 10 times"), "does not hold") << "11 times drawing everything does not count";
    for (Values& v : rows[2].values) v[M::total_ms] = 51;
    EXPECT_EQ(judged(rows, "more than 10 times"), "holds");
    const Results results = results_of(rows);
    const auto claims = judge_claims(results);
    EXPECT_EQ(find(claims, "more than 10 times")->regimes[0].figures,
              "10.2 times as fast as view culling (11 times as drawing everything)");
    rows.pop_back();
    EXPECT_EQ(judged(rows, "more than 10 times"), "not judged") << "without the baseline";

    const auto overhead = [&](double traversal) {
        return judged({with(report_row("room", "published", "10%", 9, 0, 1), {{M::traverse_ms, traversal}}),
                       with(report_row("room", "view", "unlimited", 20, 0, 1), {{M::traverse_ms, 3}})},
                      "negligible");
    };
    EXPECT_EQ(overhead(4.9), "holds") << "1.9 of 20 ms more";
    EXPECT_EQ(overhead(5.1), "does not hold");
    EXPECT_EQ(overhead(1), "holds") << "it may be less";
}

TEST(LabClaims, AboutOrdersOfCells) {
    const auto rows = [](double delaunay, double tree, double sorted) {
        return std::vector{with(report_row("city", "published", "10%", 9, delaunay, 1 - delaunay), {{M::zeta, 1}}),
                           with(report_row("city", "published@tree", "10%", 5, tree, 1 - tree), {{M::zeta, 2}}),
                           report_row("city", "centroid", "10%", 9, sorted, 1 - sorted)};
    };
    EXPECT_EQ(judged(rows(0.03, 0.08, 0.3), "more than octree cells (64 %)"), "holds");
    EXPECT_EQ(judged(rows(0.03, 0.31, 0.3), "more than octree cells (64 %)"), "does not hold");
    EXPECT_EQ(judged(rows(0.03, 0.08, 0.3), "fewest wrong pixels"), "holds");
    EXPECT_EQ(judged(rows(0.09, 0.08, 0.3), "fewest wrong pixels"), "does not hold");
    EXPECT_EQ(judged(rows(0.03, 0.08, 0.3), "at most 4 %"), "holds");
    EXPECT_EQ(judged(rows(0.05, 0.08, 0.3), "at most 4 %"), "does not hold");
    EXPECT_EQ(judged(rows(0.05, 0.08, 0.3), "at most 9 %"), "holds");
    EXPECT_EQ(judged(rows(0, 0, 0), "faster on octree cells"), "holds");
    EXPECT_EQ(judged(rows(0, 0, 0), "keep to the layers"), "holds");
    const Results results = results_of(rows(0.03, 0.31, 0.3));
    const auto claims = judge_claims(results);
    EXPECT_EQ(row_to_show(*find(claims, "more than octree cells (64 %)")), &results.rows[1]);
}

TEST(LabClaims, AboutPoppingNeedNeighbouringFrames) {
    const auto popping = [](const char* path, double pop, double flip) {
        return judged({along(with(report_row("city", "published", "10%", 9, 0, 1),
                                  {{M::pop, pop}, {M::visible_change, 0.1}, {M::flip, flip}}),
                             path)},
                      "popping");
    };
    EXPECT_EQ(popping("street:60-67", 0.05, 0.001), "holds");
    EXPECT_EQ(popping("street:60-67", 0.15, 0.001), "does not hold") << "more than the exact set changes";
    EXPECT_EQ(popping("street:60-67", 0.05, 0.02), "does not hold") << "more pixels than one in a hundred";
    EXPECT_EQ(popping("street", 0.05, 0.001), "not judged");
    EXPECT_EQ(judged({along(report_row("city", "published", "10%", 9, 0, 1), "street:60-67")}, "over 90 %"),
              "not judged")
        << "a few frames stand for no path";
}

TEST(LabClaims, AboutStabilityHoldEveryMethodAgainstLayersOnItsCells) {
    const auto row = [](const char* method, double pop, double flip, const char* budget = "10%") {
        return along(with(report_row("city", method, budget, 9, 0, 1), {{M::pop, pop}, {M::flip, flip}}),
                     "street:60-67");
    };
    const char* const words = "stable between nearby viewpoints too";
    const std::vector<Row> rows{row("layers", 0.05, 0.01),          row("layers@tree", 0.2, 0.02),
                                row("published@tree", 0.204, 0.02), row("centroid", 0.054, 0.014),
                                row("hzb", 0.9, 0.9, "unlimited"),  row("published", 0.9, 0.9, "5%")};
    EXPECT_EQ(judged(rows, words), "holds");
    const Results results = results_of(rows);
    EXPECT_EQ(find(judge_claims(results), words)->regimes[0].figures, "all 2 methods; layers pop 5 % and flip 1 %");
    for (const auto& [pop, flip] : {std::pair{0.056, 0.01}, std::pair{0.05, 0.016}}) {
        std::vector<Row> worse = rows;
        worse.push_back(row("published", pop, flip));
        EXPECT_EQ(judged(worse, words), "does not hold") << pop;
        const Results of_worse = results_of(worse);
        const auto claims = judge_claims(of_worse);
        EXPECT_EQ(row_to_show(*find(claims, words)), &of_worse.rows.back());
    }
    EXPECT_EQ(judged({row("published", 0.1, 0.1), row("layers@tree", 0.1, 0.1)}, words), "not judged")
        << "nothing to hold it against";
}

TEST(LabClaims, AboutRoomAreJudgedFromInside) {
    const auto room = [](const char* path, double coverage, double visible) {
        return std::vector{
            along(report_row("room", "published", "10%", 9, 0.2, coverage), path),
            along(report_row("room", "published@tree", "10%", 9, 0.1, coverage), path),
            along(report_row("room", "centroid", "10%", 9, 0.3, coverage), path),
            along(with(report_row("room", "view", "unlimited", 9, 0, 1), {{M::rendered, 1000}, {M::visible, visible}}),
                  path)};
    };
    std::vector<Row> rows = room("walk", 0.5, 200);
    EXPECT_EQ(judged(rows, "from outside"), "not judged");
    for (const Row& row : room("outside", 1, 10)) rows.push_back(row);
    EXPECT_EQ(judged(rows, "from outside"), "holds");
    const Results results = results_of(rows);
    const auto claims = judge_claims(results);
    EXPECT_EQ(find(claims, "from outside")->regimes.size(), 1u);
    EXPECT_EQ(find(claims, "best image")->regimes.size(), 1u) << "the papers' pictures are from inside";
    EXPECT_EQ(judgement(*find(claims, "best image")), Judgement::holds);
    EXPECT_EQ(judgement(*find(claims, "well by the count")), Judgement::holds);
    for (Row& row : rows)
        if (row.path == "outside" && row.method.id() == "view") row = with(row, {{M::visible, 300}});
    EXPECT_EQ(judged(rows, "from outside"), "does not hold");
}

TEST(LabClaims, EachCitesWhereItStands) {
    std::vector<Row> rows;
    for (const char* scene : {"city", "cars", "room", "plant", "soda"})
        for (const char* path : {"street", "street:60-67", "outside"})
            for (const char* budget : {"1%", "5%", "10%", "unlimited"})
                for (const char* method : {"published", "published@tree", "centroid", "view", "layers", "cplp",
                                           "coorg-teller", "coorg-teller connected=on", "coorg-teller coherence=off"})
                    rows.push_back(along(with(report_row(scene, method, budget, 9, 0.1, 0.5), {{M::zeta, 1},
                                                                                               {M::pop, 0},
                                                                                               {M::flip, 0},
                                                                                               {M::visible_change, 0},
                                                                                               {M::traverse_ms, 1},
                                                                                               {M::rendered, 1000}}),
                                         path));
    const auto claims = judge_claims(results_of(rows));
    EXPECT_EQ(claims.size(), 27u) << "every one is judged";
    for (const Claim& claim : claims) {
        EXPECT_TRUE(claim.source.starts_with("TVCG ") || claim.source.starts_with("gem, ") ||
                    claim.source.starts_with("CT "))
            << claim.text;
        EXPECT_EQ(claim.source.find("5.1"), std::string::npos) << claim.text << ": 5.1 is about preprocessing";
    }
}

TEST(LabClaims, OfTheGemAreJudgedInThePlant) {
    const auto rows = [](double wrong_in_three, double wrong_in_one, double cplp_ms) {
        Row plp = report_row("plant:200k", "layers@tree", "1%", 20, wrong_in_three, 0.5, 4);
        plp.values[1][M::wrong] = wrong_in_one;
        return std::vector{std::move(plp), report_row("plant:200k", "cplp@tree first=layers", "1%", cplp_ms, 0, 1, 4)};
    };
    EXPECT_EQ(judged(rows(0.01, 0.1, 100), "96.3 %"), "holds");
    EXPECT_EQ(judged(rows(0.01, 0.2, 100), "96.3 %"), "does not hold") << "the mean";
    EXPECT_EQ(judged(rows(0.01, 0.1, 100), "10.1 frames"), "holds") << "50 and 10 Hz";
    EXPECT_EQ(judged(rows(0.01, 0.1, 30), "10.1 frames"), "does not hold");
    EXPECT_EQ(judged(rows(0.01, 0.1, 100), "misses nothing"), "holds");
    EXPECT_EQ(judged({rows(0, 0, 1)[0]}, "10.1 frames"), "not judged") << "without cPLP";
    const TextTable table = gem_table(results_of(rows(0.01, 0.05, 100)));
    ASSERT_EQ(table.rows.size(), 4u);
    EXPECT_EQ(table.rows[0],
              (std::vector<std::string>{"power plant (gem)", "PLP by layers", "1.08%", "10.1", "9.3", "96.3", "94.9"}));
    EXPECT_EQ(table.rows[2],
              (std::vector<std::string>{"plant:200k, test", "layers@tree", "1%", "50", "50", "98", "98"}));
    EXPECT_TRUE(gem_table(results_of({report_row("city", "layers", "1%", 1, 0, 1)})).rows.empty());
}

TEST(LabClaims, OfCoorgAndTellerAreJudgedOnTheirModels) {
    const auto rows = [](const char* scene, double drawn, double ms) {
        const auto row = [&](const char* method, double rendered, double traverse) {
            return with(report_row(scene, method, "unlimited", 1, 0, 1),
                        {{M::rendered, rendered}, {M::traverse_ms, traverse}});
        };
        return std::vector{row("coorg-teller", 100, 1), row("coorg-teller connected=on", drawn, ms),
                           row("coorg-teller coherence=off", 100, 3)};
    };
    EXPECT_EQ(judged(rows("soda", 90, 0.9), "Connected occluders"), "holds");
    EXPECT_EQ(judged(rows("blocks", 90, 1.1), "Connected occluders"), "does not hold") << "slower";
    EXPECT_EQ(judged(rows("tetra", 110, 0.9), "Connected occluders"), "does not hold") << "culls less";
    EXPECT_EQ(judged(rows("city", 90, 0.9), "Connected occluders"), "not judged") << "no model of theirs";
    std::vector<Row> city = rows("city", 90, 0.9);
    city.push_back(with(report_row("city", "view", "unlimited", 1, 0, 1), {{M::rendered, 179}, {M::visible, 20}}));
    EXPECT_EQ(judged(city, "many small polygons"), "holds") << "79 of 159";
    city.back() = with(city.back(), {{M::rendered, 181}});
    EXPECT_EQ(judged(city, "many small polygons"), "does not hold") << "81 of 161";
    EXPECT_EQ(judged(rows("soda", 90, 0.9), "kept from frame to frame"), "holds");
}

TEST(PapersTables, PutTheirFiguresBesideOurs) {
    std::vector<Row> rows{report_row("city:50k", "published", "5%", 5, 0, 0.85),
                          report_row("city:50k", "published@tree", "10%", 9, 0, 0.6),
                          along(report_row("city:50k", "published", "5%", 9, 0, 0.7), "street:60-67"),
                          report_row("plant", "published", "5%", 5, 0, 0.85),
                          report_row("cars", "published", "1%", 5, 0, 0.5)};
    for (Row& row : rows) {
        row.tessellation.seconds = 2;
        row.tessellation.cell_bytes = 50 * 80;
        row.tessellation.references = 1500;
        row.tessellation.reference_bytes = 6000;
        row.tessellation.scene_bytes = 40000;
    }
    const Results results = results_of(rows);
    const auto table = table_1(results);
    ASSERT_EQ(table.size(), 3u);
    EXPECT_DOUBLE_EQ(table[0].ours[2], 0.85);
    EXPECT_DOUBLE_EQ(table[0].papers[2], 0.80);
    EXPECT_TRUE(std::isnan(table[0].ours[0]));
    EXPECT_TRUE(std::isnan(table[1].papers[2])) << "they give none for the octree";
    EXPECT_NE(markdown(text_table(table)).find("| CITY (TVCG table 1) | published | 51 | 66 | 80 | 90 |"),
              std::string::npos);
    EXPECT_NE(markdown(text_table(table)).find("| city:50k, test | published | – | – | 85 | – |"), std::string::npos);

    const auto cells = preprocessing(results);
    ASSERT_EQ(cells.size(), 6u) << "two of the city, CITY, plant, cars, 5CBEM";
    EXPECT_DOUBLE_EQ(cells[0].bytes_per_cell, 80);
    EXPECT_DOUBLE_EQ(cells[0].references_per_primitive, 1.5);
    EXPECT_DOUBLE_EQ(cells[0].memory_share, 0.25);
    EXPECT_EQ(cells[1].tessellation, "tree");
    EXPECT_EQ(cells[2].scene, "CITY (TVCG 5.1)");
    EXPECT_DOUBLE_EQ(cells[2].references_per_primitive, 1.80);
    EXPECT_EQ(cells[3].scene, "plant");
    EXPECT_EQ(cells[5].scene, "5CBEM (TVCG 5.1)");
    EXPECT_NE(html(text_table(cells), "a & b").find("a &amp; b"), std::string::npos);

    const Results again = read_results(results_json(results, "[]"), "again");
    EXPECT_EQ(preprocessing(again)[0].memory_share, 0.25);
    EXPECT_EQ(again.rows[0].tessellation.seconds, 2);
}

}  // namespace
}  // namespace sightline::lab
