// The trade-off panel in the real window, by real keys and clicks; and off screen, frame by frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "shell/commands/command_table.h"
#include "shell/desk/measure_trade_off.h"
#include "shell/desk/open_scene.h"
#include "tests/shell/desk/bench_support.h"
#include "tests/shell/window/window_driver.h"
#include "tests/shell/window/window_session_support.h"
#include "viewer2d/stage2d.h"

namespace sightline {
namespace {

using namespace test;

TEST_F(WindowSession, TheTradeOffFillsItselfAndAClickOnADotSetsMethodAndBudget) {
    SHOW_DISPLAY();
    start({"rooms"});
    if (HasFatalFailure()) return;
    hands->key("6");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Trade-off", "measured all "); }));
    for (const std::string dot : {"layers 5%", "published 10%", "view unlimited"}) {
        ASSERT_TRUE(now.screen.contains("dot " + dot)) << dot;
        const Rect at = now.screen.at("dot " + dot);
        hands->click(at.x + at.w / 2, at.y + at.h / 2);
        hands->move(3, 3);
        const std::string method = dot.substr(0, dot.find(' '));
        ASSERT_TRUE(becomes([&](const Dump& d) { return d.has("Run", "(" + method + ")"); })) << dot;
        EXPECT_NE(now.after("Trade-off", dot + ": ").find("(now)"), std::string::npos) << now.panels["Trade-off"];
    }
    EXPECT_TRUE(now.has("Trade-off", "measured all ")) << "a click on a dot made it begin anew";
    hands->key("ctrl+z");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Run", "(published)"); }));

    // Another tessellation begins anew and says so; the other axis.
    command("set error_bound=0.2");
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Trade-off", "restarted: another tessellation"); }));
    ASSERT_TRUE(becomes([](const Dump& d) { return d.has("Trade-off", "measured all "); }));
    const Rect wrong = now.screen.at("dot layers 5%"), button = now.screen.at("trade-off measure");
    hands->click(button.x + button.w / 2, button.y + button.h / 2);
    hands->move(3, 3);
    ASSERT_TRUE(becomes([&](const Dump& d) { return d.screen.at("dot layers 5%").y != wrong.y; }));
    leave();
}

/// The window off screen.
class TradeOffOffScreen : public ::testing::Test {
protected:
    TradeOffOffScreen()
        : kept(open_scene("streets", start_settings("streets"), method_table<2>(), [](const auto&) {})) {}
    void SetUp() override {
        try {
            driver = std::make_unique<WindowDriver<2>>(bench, 960, 600, stage2d);
        } catch (const WorkError& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
    }
    std::size_t done() const { return bench.trade_off.study.done(); }
    /// Whether frames measure something, from the beginning.
    bool measures() {
        const bool stopped = bench.trade_off.stopped;
        restart_trade_off(bench);
        bench.trade_off.stopped = stopped;
        driver->frames(25);
        return done() > 0;
    }

    Bench kept;
    Workbench<2>& bench = kept.bench;
    std::unique_ptr<WindowDriver<2>> driver;
};

TEST_F(TradeOffOffScreen, MeasuresOnlyWhereAPersonWatchesAndNothingMoves) {
    EXPECT_FALSE(measures()) << "the panel is not shown";
    run_commands(bench, "show trade-off");
    EXPECT_TRUE(measures());
    driver->move(300, 300);
    driver->frames(1);
    driver->button(true);
    driver->frames(1);
    EXPECT_FALSE(measures()) << "a button is down";
    driver->button(false);
    driver->frames(2);
    EXPECT_TRUE(measures());
    run_commands(bench, "seek 0; play");
    bench.transport.steps_per_second = slowest;
    EXPECT_FALSE(measures()) << "it plays";
    run_commands(bench, "pause; trade-off stop");
    EXPECT_FALSE(measures()) << "it was stopped";
    const Place* const go = driver->place("trade-off go");
    ASSERT_TRUE(go);
    driver->click(go->x + go->w / 2, go->y + go->h / 2);
    EXPECT_FALSE(bench.trade_off.stopped);
    EXPECT_TRUE(measures());
    run_commands(bench, "show why");
    EXPECT_FALSE(measures()) << "nobody watches";
    run_commands(bench, "show trade-off; projector");
    EXPECT_FALSE(measures()) << "nobody watches";
}

}  // namespace
}  // namespace sightline
