// What Why says of a box whose fate planes decide.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/draw/shown_boxes.h"
#include "core/draw/shown_planes.h"
#include "core/session/state_file.h"
#include "shell/commands/command_table.h"
#include "shell/desk/open_scene.h"
#include "shell/panels/panel.h"
#include "shell/panels/panel_table.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

Workbench<2> wall_bench(const std::string& method = "coorg-teller") {
    Session<2> session = open_scene("wall2", start_settings("wall2"), method_table<2>(), [](const std::string&) {});
    Workbench<2> bench{std::move(session), {}, Stop::none, false, [](const std::string&) {}};
    test::record_ahead(bench);
    run_commands(bench, "budget unlimited; method " + method + "; run");
    return bench;
}

std::uint32_t first_box(const Workbench<2>& bench, CellState state) {
    for (const ShownBox<2>& shown : shown_boxes(bench.session))
        if (shown.state == state) return shown.node;
    return none;
}

/// Rows from the heading on that starts so, without it, to the next heading.
std::vector<Row> rows_under(const std::vector<Row>& rows, const std::string& heading) {
    auto from = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return row.tone == Tone::heading && row.text.starts_with(heading);
    });
    if (from == rows.end()) return {};
    const auto end = std::find_if(++from, rows.end(), [](const Row& row) { return row.tone == Tone::heading; });
    return {from, end};
}

TEST(WhyBox, EachPlaneHasARowTheFailingOnesFirst) {
    Workbench<2> bench = wall_bench();
    for (const CellState state : {CellState::hidden, CellState::projected}) {
        for (const ShownBox<2>& shown : shown_boxes(bench.session)) {
            if (shown.state != state) continue;
            run_commands(bench, "select node:" + std::to_string(shown.node));
            const auto planes = planes_at_hand(bench.session);
            const auto rows = rows_under(why_rows(bench), "Planes to the occluder");
            ASSERT_EQ(rows.size(), planes.size());
            bool satisfied = false;
            for (const Row& row : rows) {
                const std::uint32_t i = static_cast<std::uint32_t>(std::stoul(row.command.substr(13)));
                ASSERT_EQ(row.command, "select plane:" + std::to_string(i));
                ASSERT_GE(planes[i].satisfied, satisfied) << "those that fail stand first";
                satisfied = planes[i].satisfied;
                ASSERT_EQ(row.text.find("not satisfied") == std::string::npos, satisfied) << row.text;
                ASSERT_TRUE(row.text.ends_with(", " + short_number(planes[i].distance))) << row.text;
                if (planes[i].kind != PlaneKind::own) {
                    ASSERT_NE(row.text.find(plane_kind_words[static_cast<std::size_t>(planes[i].kind)]),
                              std::string::npos);
                    ASSERT_NE(row.text.find("end " + std::to_string(planes[i].edge)), std::string::npos);
                }
            }
            if (state == CellState::hidden &&
                bench.session.traversal().tested_occluders({shown.node, Kind::node}).size() > 0) {
                ASSERT_TRUE(rows.empty() || rows.front().tone == Tone::good);
            }
        }
    }
}

TEST(WhyBox, AClickOnAPlaneLightsItAndAnotherTakesItBack) {
    Workbench<2> bench = wall_bench();
    run_commands(bench, "select node:" + std::to_string(first_box(bench, CellState::hidden)));
    const auto rows = rows_under(why_rows(bench), "Planes to the occluder");
    ASSERT_GT(rows.size(), 2u);
    run_commands(bench, rows[2].command);
    EXPECT_EQ("select plane:" + std::to_string(bench.session.selected_plane), rows[2].command);
    EXPECT_EQ(rows_under(why_rows(bench), "Planes to the occluder")[2].tone, Tone::lit);
    run_commands(bench, rows[2].command);
    EXPECT_EQ(bench.session.selected_plane, none);
    run_commands(bench, rows[1].command + "; select none");
    EXPECT_EQ(bench.session.selected_plane, none);
    EXPECT_EQ(bench.session.selected_node, none);
    EXPECT_THROW(run_commands(bench, "select plane:99"), InputError);
    EXPECT_THROW(run_commands(bench, "select node:99999"), InputError);
    run_commands(bench, "method published");
    EXPECT_THROW(run_commands(bench, "select node:0"), InputError);
}

TEST(WhyBox, TheOccludersTestedAndHandedOnAreListed) {
    for (const char* method : {"coorg-teller", "coorg-teller connected=on", "shadow-frusta"}) {
        Workbench<2> bench = wall_bench(method);
        std::size_t handed_on = 0;
        for (const ShownBox<2>& shown : shown_boxes(bench.session)) {
            if (shown.state == CellState::unseen) continue;
            run_commands(bench, "select node:" + std::to_string(shown.node));
            const auto tested = bench.session.traversal().tested_occluders({shown.node, Kind::node});
            const auto rows = why_rows(bench);
            const auto all = rows_under(rows, "Tested against it: S");
            ASSERT_EQ(all.size(), std::max<std::size_t>(tested.size(), 1));
            std::size_t on = 0, hides = 0;
            for (std::size_t i = 0; i < tested.size(); ++i) {
                on += tested[i].handed_on;
                hides += tested[i].hides;
                ASSERT_NE(all[i].text.find("region " + std::to_string(tested[i].region)), std::string::npos);
                Workbench<2> clicked = bench;
                run_commands(clicked, all[i].command);
                ASSERT_EQ(clicked.session.selected_primitive, tested[i].primitives.front());
                ASSERT_EQ(box_at_hand(clicked.session), shown.node);
            }
            ASSERT_EQ(hides > 0, shown.state == CellState::hidden);
            ASSERT_TRUE(hides == 0 || on == 0) << "a box that is hidden hands nothing on";
            const auto listed = rows_under(rows, "Handed on").size() + rows_under(rows, "Of them").size();
            ASSERT_EQ(listed, on);
            handed_on += on;
        }
        EXPECT_GT(handed_on, 0u);
    }
}

TEST(WhyBox, EveryLineCanBeClicked) {
    Workbench<2> bench = wall_bench();
    for (const char* text : {"seek 20", "seek 20; select node:last", "seek 40; select primitive:0",
                             "run; select node:3", "select primitive:500"}) {
        run_commands(bench, text);
        for (const Row& row : why_rows(bench)) {
            EXPECT_FALSE(row.text.empty());
            Workbench<2> clicked = bench;
            EXPECT_NO_THROW(run_commands(clicked, row.command)) << row.text;
        }
    }
}

TEST(WhyBox, AStateKeepsWhatIsSelected) {
    Workbench<2> bench = wall_bench();
    run_commands(bench, "select node:" + std::to_string(first_box(bench, CellState::hidden)) + "; select plane:1");
    const Session<2>& session = bench.session;
    const std::string state = state_json(session);
    const OpenedState<2> opened = open_state<2>(state, "state");
    EXPECT_EQ(opened.session.selected_node, session.selected_node);
    EXPECT_EQ(opened.session.selected_plane, 1u);
    EXPECT_EQ(state_json(opened.session), state);
}

}  // namespace
}  // namespace sightline
