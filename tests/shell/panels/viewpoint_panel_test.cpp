// The panel of a choice by viewpoint: every line of it, in one small scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "shell/commands/command_table.h"
#include "shell/desk/open_scene.h"
#include "shell/panels/panel_table.h"

namespace sightline {
namespace {

Workbench<2> bench_by_viewpoint() {
    Session<2> session =
        open_scene("bottleneck", start_settings("bottleneck"), method_table<2>(), [](const std::string&) {});
    Workbench<2> bench{std::move(session), {}, Stop::none, false, [](const std::string&) {}};
    run_commands(bench,
                 "set grid=2; set azimuths=4; set samples=1; set vertex_ns=10; set pixel_ns=0.5; "
                 "set cost=max-of-sums; method by-viewpoint");
    return bench;
}

std::string text_of_viewpoint(const Workbench<2>& bench) {
    std::string text;
    for (const Row& row : viewpoint_rows(bench)) text += as_line(row) + "\n";
    return text;
}

TEST(ViewpointPanel, SaysWhereTheEyeIsWhatIsChosenAndWhy) {
    Workbench<2> bench = bench_by_viewpoint();
    run_commands(bench, "work-out region");
    EXPECT_EQ(text_of_viewpoint(bench),
              "The eye is in box 1\n"
              "and looks along azimuth 45° to 135°\n"
              "done here: boxes\n"
              "Techniques here, with the milliseconds predicted for a frame\n"
              "  view: 0.0196 ms\n"
              "  shadow-frusta: 0.0226 ms\n"
              "  hom: 0.0284 ms\n"
              "  boxes: 0.0152 ms, chosen\n"
              "Decisions, with the milliseconds after each\n"
              "  1. view: 0.0196 ms = culling 0.00785 + drawing 0.0118 (135 primitives)\n"
              "  2. shadow-frusta: 0.0226 ms = culling 0.0134 + drawing 0.00924 (49 primitives)\n"
              "  3. hom: 0.0284 ms = culling 0.0212 + drawing 0.00722 (53 primitives)\n"
              "  4. boxes: 0.0152 ms = culling 0.0096 + drawing 0.0056 (5 primitives)\n"
              "  5. least: boxes\n"
              "What the table knows\n"
              "4 of 16 entries worked out: 4 regions, each with 4 directions\n"
              "work out the next entry and go there\n"
              "work out all: 12 entries\n"
              "Directions from this region, by azimuth\n"
              "  −45° to 45°: hom\n"
              "  45° to 135°: boxes, looked into\n"
              "  135° to 225°: view\n"
              "  225° to 315°: view\n");
}

TEST(ViewpointPanel, SaysThatTheTechniqueOfTheFrameBeforeStaysWhereAChangeDoesNotPay) {
    Workbench<2> bench = bench_by_viewpoint();
    // Towards where all is seen, then back: at a price that nothing pays, what was done first is done for ever.
    const ViewSpec<2> view = bench.session.culling_view();
    const std::string here = std::to_string(view.eye.x) + "," + std::to_string(view.eye.y);
    run_commands(bench, "set switch_ms=1000; run; frame keep; look " + std::to_string(view.eye.x - 1) + "," +
                            std::to_string(view.eye.y) + "; run");
    const ViewpointFact<2> fact = bench.session.traversal().viewpoint().value();
    ASSERT_NE(fact.done, fact.chosen);
    const std::string text = text_of_viewpoint(bench);
    EXPECT_NE(text.find(fact.techniques[fact.done].name + ": "), std::string::npos);
    EXPECT_NE(text.find(", the one of the frame before\n"), std::string::npos) << text;
    EXPECT_NE(text.find("changing to " + fact.techniques[fact.chosen].name +
                        " would not pay: " + fact.techniques[fact.done].name + " stays\n"),
              std::string::npos)
        << text;
}

TEST(ViewpointPanel, EveryLineThatCanBeClickedDoesSomething) {
    Workbench<2> bench = bench_by_viewpoint();
    std::size_t clicks = 0;
    for (const Row& row : viewpoint_rows(bench)) {
        if (row.command.empty()) continue;
        ++clicks;
        Workbench<2> clicked = bench_by_viewpoint();
        run_commands(clicked, row.command);
        const auto fact = clicked.session.traversal().viewpoint();
        if (row.command.starts_with("method"))
            EXPECT_EQ("method \"" + clicked.session.settings().method + "\"", row.command);
        else
            EXPECT_GT(fact.value().known, 1u) << row.command;
    }
    EXPECT_EQ(clicks, 7u) << "four techniques and three ways to work out more";
    run_commands(bench, "method published");
    const auto rows = viewpoint_rows(bench);
    EXPECT_EQ(rows.back().command, "method by-viewpoint");
}

TEST(ViewpointPanel, ShowsHowFarWorkIsAndStopsItByAClick) {
    Workbench<2> bench = bench_by_viewpoint();
    bench.attended = true;
    run_commands(bench, "work-out all");
    const auto rows = viewpoint_rows(bench);
    const auto row = std::find_if(rows.begin(), rows.end(), [](const Row& r) { return r.command == "work-out stop"; });
    ASSERT_NE(row, rows.end());
    EXPECT_EQ(row->text, "working out: 1 of 16 entries (click to stop)");
    run_commands(bench, row->command);
    EXPECT_FALSE(bench.work_out);
}

}  // namespace
}  // namespace sightline
