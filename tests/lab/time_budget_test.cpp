// Flights with a budget in time: which are flown, what is counted, and that they are read back. Nothing asserts a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "lab/measure/lab_scene.h"
#include "lab/measure/time_budget.h"

namespace sightline::lab {
namespace {

TimedFlight flight_of(std::initializer_list<double> totals) {
    TimedFlight flight{"city", "air", {"published"}, "8ms", 8, {}};
    for (const double total : totals) flight.frames.push_back({100, 1, 2, 3, total});
    return flight;
}

TEST(TimeBudget, KeepsFramesWithinATenth) {
    const TimedFlight flight = flight_of({7, 8.7, 8.9, 20});
    EXPECT_EQ(share_kept(flight), 0.5);
    EXPECT_EQ(longest_ms(flight), 20);
    EXPECT_TRUE(std::isnan(share_kept(flight_of({}))));
    EXPECT_TRUE(std::isnan(longest_ms(flight_of({}))));
}

TEST(TimeBudget, IsReadBack) {
    const std::string text = flights_json({flight_of({7, 8.5}), flight_of({})});
    EXPECT_EQ(text.find('\n'), std::string::npos) << "a checkpoint is a line";
    const std::vector<TimedFlight> read = read_flights(text);
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].method, flight_of({}).method);
    EXPECT_EQ(read[0].budget, "8ms");
    ASSERT_EQ(read[0].frames.size(), 2u);
    EXPECT_EQ(read[0].frames[1].total_ms, 8.5);
    EXPECT_EQ(flights_json(read), text);
}

TEST(TimeBudget, FliesMethodsWithABudgetOnceForEachRepeat) {
    Study study;
    study.scenes = {"3d:bottleneck"};
    study.frames = 3;
    study.size = {160, 120};
    study.repeats = 2;
    study.methods = {{"published"}, {"view"}};
    study.budgets = {parse_budget("5%"), parse_budget("1e9ms")};
    const LabScene<3> lab = load_lab_scene<3>("bottleneck", "", study);
    std::size_t drawn = 0;
    Instruments instruments;
    EXPECT_TRUE(fly_in_time(lab, study, instruments, [] { return true; }).empty()) << "nothing can be drawn";
    instruments.time_drawing = [&](const auto&, const auto&, std::span<const std::uint32_t>) {
        ++drawn;
        return DrawTimes{0.25, 0.5};
    };
    const std::vector<TimedFlight> flights = fly_in_time(lab, study, instruments, [] { return true; });
    ASSERT_EQ(flights.size(), 1u);
    EXPECT_EQ(flights[0].method.variant, "published");
    EXPECT_EQ(flights[0].budget, "1e+09ms");
    const std::size_t frames = lab.views.size();
    EXPECT_EQ(flights[0].frames.size(), 2 * frames);
    EXPECT_EQ(drawn, 3 * frames) << "one flight warms up";
    EXPECT_EQ(flights[0].frames[0].draw_ms, 0.5);
    EXPECT_GT(flights[0].frames[0].rendered, 0u);
    EXPECT_TRUE(fly_in_time(lab, study, instruments, [] { return false; }).empty()) << "stopped";
}

}  // namespace
}  // namespace sightline::lab
