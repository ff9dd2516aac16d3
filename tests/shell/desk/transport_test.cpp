// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "core/scene/make/catalogue.h"
#include "shell/desk/change.h"
#include "shell/desk/moves.h"
#include "shell/desk/play.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

/// A run of more than 50 steps.
Session<2> long_run() {
    const CatalogueRow<2>& row = *find_in_catalogue("bottleneck");
    return {std::make_shared<const Scene<2>>(make_scene(row)), row.view, {}};
}

class TransportOf : public ::testing::Test {
protected:
    TransportState state() const { return transport_state(bench); }
    std::uint32_t position() const { return bench.session.position(); }
    /// A second at 4 steps a second.
    void four_steps() {
        bench.transport.steps_per_second = 4;
        for (int i = 0; i < 4; ++i) advance_clock(bench, 0.25);
    }

    test::Bench on{long_run()};
    Workbench<2>& bench = on.bench;
};

TEST_F(TransportOf, StandsReadyAndPlays) {
    EXPECT_EQ(state(), TransportState::ready);
    four_steps();
    EXPECT_EQ(position(), 0u) << "the clock makes no step before it is asked to";
    play(bench);
    EXPECT_EQ(state(), TransportState::playing);
    four_steps();
    EXPECT_EQ(position(), 4u);
    EXPECT_EQ(state(), TransportState::playing);
}

TEST_F(TransportOf, PausesWhenAsked) {
    play(bench);
    four_steps();
    pause(bench);
    EXPECT_EQ(state(), TransportState::paused);
    four_steps();
    EXPECT_EQ(position(), 4u);
    play(bench);
    EXPECT_EQ(state(), TransportState::playing);
    four_steps();
    EXPECT_EQ(position(), 8u) << "it goes on from where it stood";
    pause(bench);
    go_to_step(bench, 0);
    EXPECT_EQ(state(), TransportState::ready);
}

TEST_F(TransportOf, PausesAtBreakpoints) {
    bench.session.breakpoints = {{"step:3", true}, {"step:2", false}};
    for (const bool ahead : {false, true}) {
        if (ahead) test::record_ahead(bench);
        go_to_step(bench, 0);
        play(bench);
        four_steps();
        EXPECT_EQ(position(), 3u);
        EXPECT_EQ(state(), TransportState::paused);
        EXPECT_EQ(bench.last_stop, Stop::breakpoint);
        play(bench);
        four_steps();
        EXPECT_EQ(position(), 7u) << "a breakpoint that it stands at does not hold it";
        // Also when many steps are due at once.
        go_to_step(bench, 0);
        play(bench);
        bench.transport.steps_per_second = 1024;
        advance_clock(bench, 0.25);
        EXPECT_EQ(position(), 3u);
        pause(bench);
    }
}

TEST_F(TransportOf, FinishesAtTheEmptyFrontAndAtTheBudget) {
    for (const char* budget : {"unlimited", "10"}) {
        Settings settings = bench.session.settings();
        settings.budget = parse_budget(budget);
        change_settings(bench, settings);
        const Session<2> end = at_the_end(bench.session);
        go_to_step(bench, 0);
        play(bench);
        bench.transport.steps_per_second = fastest;
        advance_clock(bench, 0.25);
        EXPECT_EQ(position(), end.position());
        EXPECT_EQ(state(), TransportState::finished);
        EXPECT_FALSE(bench.transport.playing);
        step_back(bench, 1);
        EXPECT_EQ(state(), TransportState::paused);
        run_to_end(bench);
        EXPECT_EQ(state(), TransportState::finished);
        go_to_step(bench, 0);
        EXPECT_EQ(state(), TransportState::ready);
        run_to_end(bench);
        play(bench);
        EXPECT_EQ(position(), 0u) << "from the start again";
        EXPECT_EQ(state(), TransportState::playing);
        pause(bench);
    }
}

TEST_F(TransportOf, ChangesOfTheTraversalPauseIt) {
    play(bench);
    change_view(bench, bench.session.culling_view());
    EXPECT_EQ(state(), TransportState::ready);
}

TEST_F(TransportOf, TheClockMakesExactlyTheStepsThatAreDue) {
    Random random(95);
    for (int i = 0; i < 100; ++i) {
        go_to_step(bench, 0);
        bench.transport.steps_per_second = std::ldexp(1.0, static_cast<int>(random.below(8)) - 2);
        play(bench);
        double seconds = 0;
        while (bench.transport.playing) {
            const double tick = static_cast<double>(1 + random.below(16)) / 64;
            advance_clock(bench, tick);
            seconds += tick;
            const double due = std::floor(seconds * bench.transport.steps_per_second);
            if (bench.transport.playing) {
                ASSERT_EQ(position(), due);
            }
        }
        EXPECT_EQ(state(), TransportState::finished);
    }
    // After a long pause of the machine it goes on, it does not jump.
    go_to_step(bench, 0);
    bench.transport.steps_per_second = 16;
    play(bench);
    advance_clock(bench, 3600);
    EXPECT_EQ(position(), 4u);
}

TEST_F(TransportOf, PlaysTheWholeRunInATime) {
    const std::uint32_t steps = whole_run(bench);
    play_whole_run_in(bench, 2);
    EXPECT_DOUBLE_EQ(bench.transport.steps_per_second, steps / 2.0);
    play_whole_run_in(bench, 1e9);
    EXPECT_EQ(bench.transport.steps_per_second, slowest);
    play_whole_run_in(bench, 1e-9);
    EXPECT_EQ(bench.transport.steps_per_second, fastest);
}

}  // namespace
}  // namespace sightline
