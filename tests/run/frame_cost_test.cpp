// What a frame will cost after its traversal, learned from frames, and the driver that leaves room for it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/run/drive.h"

namespace sightline {
namespace {

constexpr double budget = 8;

TEST(FrameCost, BeforeTheFirstFrameLeavesRoomForASlowRasteriser) {
    const FrameCost cost = predict_cost({}, budget);
    EXPECT_GE(cost.fixed_ms, budget / 4);
    EXPECT_GE(cost.per_primitive_ms, 0.001);
    EXPECT_GT(traversal_ms_left(budget, 0, cost, 1000), 0) << "but something may be rendered";
}

TEST(FrameCost, LearnsALineWithNoise) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const double fixed = 4 * random.unit(), each = 0.002 * random.unit();
        DrawnFrames frames;
        for (int f = 0; f < 40; ++f) {
            const auto n = static_cast<std::uint32_t>(1000 + random.below(9000));
            note_frame(frames, n, fixed + each * n + 0.2 * random.unit());
        }
        const FrameCost cost = predict_cost(frames, budget);
        for (const std::uint32_t n : {1000u, 5000u, 10000u}) {
            const double exact = fixed + each * n;
            EXPECT_GE(cost.ms(n), exact) << "on the safe side";
            EXPECT_LE(cost.ms(n), exact + 0.6);
        }
        for (const DrawnFrames::Frame& frame : frames.last) EXPECT_LE(frame.ms, cost.ms(frame.rendered) + 1e-9);
    }
}

TEST(FrameCost, OneFrameThatWasInterruptedChangesLittle) {
    DrawnFrames frames;
    for (std::uint32_t f = 0; f < 16; ++f) note_frame(frames, 1000 + 500 * f, 1 + 0.001 * (1000 + 500 * f));
    const FrameCost before = predict_cost(frames, budget);
    note_frame(frames, 4000, 200);
    const FrameCost after = predict_cost(frames, budget);
    EXPECT_NEAR(after.ms(4000), before.ms(4000), 0.01);
}

TEST(FrameCost, FramesOfOneSizeStillPredictThatSize) {
    DrawnFrames frames;
    for (int f = 0; f < 16; ++f) note_frame(frames, 5000, 4);
    const FrameCost cost = predict_cost(frames, budget);
    EXPECT_NEAR(cost.ms(5000), 4, 1e-9);
    EXPECT_GT(cost.per_primitive_ms, 0) << "more costs more";
}

TEST(FrameCost, IsNeverNegativeAndFollowsFromItsInput) {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        DrawnFrames a, b;
        const auto count = static_cast<std::uint32_t>(random.below(40));
        for (std::uint32_t f = 0; f < count; ++f) {
            const auto n = static_cast<std::uint32_t>(random.below(3) ? random.below(100000) : 0);
            const double ms = 30 * random.unit() * random.unit();
            note_frame(a, n, ms);
            note_frame(b, n, ms);
        }
        note_frame(a, 10, -1);
        note_frame(a, 10, std::numeric_limits<double>::quiet_NaN());
        note_frame(a, 10, std::numeric_limits<double>::infinity());
        const FrameCost cost = predict_cost(a, budget);
        EXPECT_EQ(cost, predict_cost(b, budget)) << "times that are none are not noted";
        EXPECT_GE(cost.fixed_ms, 0);
        EXPECT_GE(cost.per_primitive_ms, 0);
        EXPECT_GE(traversal_ms_left(budget, 20 * random.unit(), cost, count * 1000), 0);
    }
}

/// Steps of so many milliseconds and primitives on a clock of their own, until the driver stops them.
struct FakeRun {
    double step_ms = 0.1;
    std::uint32_t step_primitives = 100;
    double now = 0;
    std::uint32_t rendered = 0, steps = 0;

    Stop drive_to(const Budget& limit, const FrameCost& cost, std::uint32_t most = 1000) {
        return drive(
            limit, cost, most,
            [&] {
                now += step_ms;
                rendered += step_primitives;
                ++steps;
                return Stop::none;
            },
            [] { return false; }, [&] { return rendered; }, [&] { return now; });
    }
};

TEST(TimedDrive, LeavesTheTimeThatDrawingWillTake) {
    for (const double per_primitive : {0.0, 0.0005, 0.001, 0.01})
        for (const double fixed : {0.0, 1.0, 3.0}) {
            const FrameCost cost{per_primitive, fixed};
            FakeRun run;
            ASSERT_EQ(run.drive_to(parse_budget("8ms"), cost), Stop::budget);
            const double frame = run.now + cost.ms(run.rendered);
            const double step = run.step_ms + per_primitive * run.step_primitives;
            EXPECT_LE(frame, 8 + 1e-9);
            EXPECT_GT(frame + 2 * step, 8) << "nor does it stop long before";
        }
}

TEST(TimedDrive, CountsWhatTheFrameTookBefore) {
    FakeRun early, late;
    late.now = 4;
    early.drive_to(parse_budget("8ms"), {});
    late.drive_to(parse_budget("8ms"), {});
    EXPECT_NEAR(early.steps, 2 * late.steps, 2);
}

TEST(TimedDrive, MakesOneStepWhereThereIsNoTimeAtAll) {
    FakeRun run;
    EXPECT_EQ(run.drive_to(parse_budget("8ms"), {0, 100}), Stop::budget);
    EXPECT_EQ(run.steps, 1u);
}

TEST(TimedDrive, AsksNoClockWithoutABudgetInTime) {
    FakeRun run;
    EXPECT_EQ(run.drive_to(parse_budget("5%"), {0, 100}, 50), Stop::steps);
    EXPECT_EQ(run.steps, 50u);
}

}  // namespace
}  // namespace sightline
