// The timeline's mathematics: places of steps, zoom, thinned lanes, words of the ruler, marks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shell/desk/change.h"
#include "shell/desk/moves.h"
#include "shell/window/timeline_data.h"
#include "tests/shell/desk/bench_support.h"

namespace sightline {
namespace {

/// Ends of a run by steps, or by primitives with many steps that render none.
std::vector<std::uint32_t> random_ends(Random& random) {
    const std::size_t steps = 1 + random.below(300);
    std::vector<std::uint32_t> ends{0};
    const bool primitives = random.below(2) == 0;
    for (std::size_t i = 0; i < steps; ++i)
        ends.push_back(ends.back() + static_cast<std::uint32_t>(!primitives           ? 1
                                                                : random.below(3) > 0 ? 0
                                                                                      : random.below(9)));
    return ends;
}

Shares random_shares(Random& random) {
    const double a = random.uniform(0, 1), b = random.uniform(0, 1);
    return random.below(4) == 0 ? Shares{} : Shares{std::min(a, b), std::max(a, b)};
}

StepAxis random_axis(Random& random, const std::vector<std::uint32_t>& ends) {
    return make_axis(ends, random_shares(random), static_cast<float>(random.uniform(-50, 300)),
                     static_cast<float>(random.uniform(20, 2000)));
}

TEST(TimelineAxis, IsMonotoneAndItsOwnInverse) {
    Random random(1);
    for (int run = 0; run < 300; ++run) {
        const auto ends = random_ends(random);
        const StepAxis axis = random_axis(random, ends);
        ASSERT_LT(axis.from, axis.to);
        ASSERT_GE(axis.from, 0);
        ASSERT_LE(axis.to, std::max<double>(ends.back(), 1) + 1e-9);
        for (std::uint32_t step = 1; step < ends.size(); ++step) {
            EXPECT_GE(x_of_step(axis, step), x_of_step(axis, step - 1));
            EXPECT_GE(middle_of_step(axis, step), x_of_step(axis, step - 1));
            EXPECT_LE(middle_of_step(axis, step), x_of_step(axis, step));
            if (ends[step] == ends[step - 1] || x_of_step(axis, step) - x_of_step(axis, step - 1) < 0.01f) continue;
            EXPECT_EQ(step_at(axis, middle_of_step(axis, step)), step);
            EXPECT_EQ(ends[nearest_step(axis, x_of_step(axis, step))], ends[step]);
        }
        EXPECT_EQ(step_at(axis, x_of_value(axis, -1)), 0u);
        EXPECT_EQ(ends[step_at(axis, x_of_value(axis, ends.back() + 1.0))], ends.back());
        for (int i = 0; i < 10; ++i) {
            const float x = axis.x + axis.w * static_cast<float>(random.uniform(0, 1));
            EXPECT_NEAR(x_of_value(axis, value_at(axis, x)), x, 0.05);
        }
    }
}

TEST(TimelineAxis, ZoomKeepsTheStepUnderTheMouse) {
    Random random(2);
    int kept = 0;
    for (int run = 0; run < 500; ++run) {
        const auto ends = random_ends(random);
        const StepAxis axis = random_axis(random, ends);
        const float x = axis.x + axis.w * static_cast<float>(random.uniform(0, 1));
        const double value = value_at(axis, x);
        const Shares shown = zoomed(axis, x, random.uniform(0.3, 4));
        EXPECT_GE(shown.from, 0);
        EXPECT_LE(shown.to, 1);
        const StepAxis now = make_axis(ends, shown, axis.x, axis.w);
        EXPECT_GE(now.to - now.from, std::min(least_shown, std::max<double>(ends.back(), 1)) - 1e-9);
        const bool at_an_end = now.from < 1e-6 || now.to > ends.back() - 1e-6;
        if (at_an_end) continue;
        ++kept;
        EXPECT_NEAR(value_at(now, x), value, 1e-3 * (now.to - now.from) + 1e-6);
    }
    EXPECT_GT(kept, 100);
}

TEST(TimelineAxis, PanningMovesByWhatTheMouseMovesAndKeepsTheZoom) {
    Random random(3);
    for (int run = 0; run < 500; ++run) {
        const auto ends = random_ends(random);
        const StepAxis axis = random_axis(random, ends);
        const float dx = static_cast<float>(random.uniform(-100, 100));
        const StepAxis now = make_axis(ends, panned(axis, dx), axis.x, axis.w);
        EXPECT_NEAR(now.to - now.from, axis.to - axis.from, 1e-6);
        if (now.from > 1e-6 && now.to < ends.back() - 1e-6) {
            const double moved = dx / axis.w * (axis.to - axis.from);
            EXPECT_NEAR(axis.from - now.from, moved, 1e-4);
        }
        const auto step = static_cast<std::uint32_t>(random.below(ends.size()));
        const StepAxis around = make_axis(ends, centred(axis, step), axis.x, axis.w);
        EXPECT_LE(around.from, ends[step] + 1e-6);
        EXPECT_GE(around.to, ends[step] - 1e-6);
    }
}

/// Every step that covers a part of (from, to], or has no width and lies in [from, to].
TEST(TimelineAxis, StepsBetweenAreThoseOfTheDefinition) {
    Random random(4);
    for (int run = 0; run < 500; ++run) {
        const auto ends = random_ends(random);
        const StepAxis axis = make_axis(ends, {}, 0, 100);
        double from = random.uniform(0, ends.back()), to = random.uniform(0, ends.back());
        if (random.below(2) == 0) from = std::floor(from);
        if (random.below(2) == 0) to = std::floor(to);
        if (from > to) std::swap(from, to);
        if (from == to) continue;
        const StepRange range = steps_between(axis, from, to);
        for (std::uint32_t step = 1; step < ends.size(); ++step) {
            const bool wide = ends[step] > ends[step - 1];
            const bool inside =
                wide ? ends[step] > from && ends[step - 1] < to : ends[step] >= from && ends[step] <= to;
            EXPECT_EQ(step >= range.first && step <= range.last, inside) << step << " in " << from << " " << to;
        }
    }
}

TEST(TimelineSpans, KeepTheExtremesOfEverythingShown) {
    Random random(5);
    for (int run = 0; run < 300; ++run) {
        const auto ends = random_ends(random);
        const StepAxis axis = random_axis(random, ends);
        std::vector<double> values;
        for (std::size_t i = 1; i < ends.size(); ++i)
            values.push_back(random.below(10) == 0 ? std::numeric_limits<double>::quiet_NaN() : random.uniform(-5, 9));
        const auto columns = static_cast<std::uint32_t>(1 + random.below(200));
        const auto spans = lane_spans(axis, values, columns);
        EXPECT_LE(spans.size(), columns);
        const StepRange shown = steps_between(axis, axis.from, axis.to);
        for (std::uint32_t step = shown.first; step <= shown.last; ++step) {
            const double value = values[step - 1];
            if (!std::isfinite(value)) continue;
            const float x = std::clamp(middle_of_step(axis, step), axis.x, axis.x + axis.w);
            EXPECT_TRUE(std::any_of(spans.begin(), spans.end(),
                                    [&](const LaneSpan& span) {
                                        return span.x0 <= x + 0.1f && span.x1 >= x - 0.1f && span.low <= value &&
                                               span.high >= value;
                                    }))
                << "step " << step;
        }
        for (std::size_t i = 0; i < spans.size(); ++i) {
            EXPECT_GE(spans[i].x0, axis.x - 0.1f);
            EXPECT_LE(spans[i].x1, axis.x + axis.w + 0.1f);
            EXPECT_LE(spans[i].low, spans[i].high);
            EXPECT_TRUE(i == 0 || spans[i].x0 >= spans[i - 1].x1 - 0.01f);
            // No value that is none of its steps'.
            for (const double value : {spans[i].low, spans[i].high})
                EXPECT_NE(std::find(values.begin(), values.end(), value), values.end());
        }
    }
}

TEST(TimelineRuler, NoWordLiesOverAnother) {
    Random random(6);
    const auto width = [](const std::string& text) { return 7.0f * static_cast<float>(text.size()); };
    bool all = false;
    for (int run = 0; run < 500; ++run) {
        const auto ends = random_ends(random);
        const StepAxis axis = random_axis(random, ends);
        std::vector<BudgetTick> budgets;
        std::uint32_t step = 0;
        for (const char* label : {"1 %", "2 %", "5 %", "10 %"}) {
            step = std::min<std::uint32_t>(step + static_cast<std::uint32_t>(random.below(40)),
                                           static_cast<std::uint32_t>(ends.size() - 1));
            budgets.push_back({step, label});
        }
        const auto numbers = ruler_labels(axis, width, 4), shares = budget_labels(axis, budgets, width, 4);
        for (const auto& labels : {numbers, shares})
            for (std::size_t i = 0; i < labels.size(); ++i) {
                EXPECT_FALSE(labels[i].text.empty());
                EXPECT_GE(labels[i].left, axis.x - 0.1f);
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_TRUE(labels[i].left >= labels[k].left + labels[k].w + 3.9f ||
                                labels[k].left >= labels[i].left + labels[i].w + 3.9f)
                        << labels[i].text << " and " << labels[k].text;
            }
        std::string budget_words;
        for (const RulerLabel& label : shares) budget_words += label.text + ";";
        all |= budget_words == "1, 2, 5, 10 %;" || budget_words == "1, 2 %;5, 10 %;";
        EXPECT_TRUE(axis.w < 300 || numbers.size() >= 2);
    }
    EXPECT_TRUE(all) << "budgets near each other share a word";
}

TEST(TimelineRuler, NumbersAreNiceAndFarEnoughApart) {
    Random random(7);
    for (int run = 0; run < 200; ++run) {
        const auto ends = random_ends(random);
        const StepAxis axis = random_axis(random, ends);
        const auto values = nice_values(axis, 40);
        for (std::size_t i = 1; i < values.size(); ++i) {
            EXPECT_GE(x_of_value(axis, values[i]) - x_of_value(axis, values[i - 1]), 39.9f);
            double step = std::round(values[i] - values[i - 1]);
            while (step >= 10) step /= 10;
            EXPECT_TRUE(step == 1 || step == 2 || step == 5) << step;
        }
    }
}

TEST(TimelineMarks, GroupsHoldEveryMarkShownOnce) {
    Random random(8);
    for (int run = 0; run < 300; ++run) {
        const auto ends = random_ends(random);
        const StepAxis axis = random_axis(random, ends);
        std::vector<TimelineMark> marks;
        for (const MarkKind kind : {MarkKind::penalty, MarkKind::unreached, MarkKind::bookmark})
            for (std::uint32_t step = 0; step < ends.size(); ++step)
                if (random.below(3) == 0) marks.push_back({step, kind, ""});
        const auto groups = mark_groups(axis, marks, 8, 2);
        std::size_t held = 0, shown = 0;
        for (const MarkGroup& group : groups) {
            held += group.count;
            for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
                EXPECT_EQ(marks[i].kind, group.kind);
                EXPECT_NEAR(middle_of_step(axis, marks[i].step), group.x, 2.01);
            }
            // A whole shape has room.
            for (const MarkGroup& other : groups)
                EXPECT_TRUE(group.crowded || &other == &group || other.kind != group.kind ||
                            std::abs(other.x - group.x) >= 7.99f);
        }
        for (const TimelineMark& mark : marks) {
            const float x = middle_of_step(axis, mark.step);
            shown += x >= axis.x - 0.5f && x <= axis.x + axis.w + 0.5f;
        }
        EXPECT_EQ(held, shown);
    }
}

TEST(TimelineData, FollowsTheBench) {
    Random random(9);
    for (int run = 0; run < 60; ++run) {
        test::Bench held(test::random_start(random).session());
        Workbench<2>& bench = held.bench;
        test::record_ahead(bench);
        TimelineData data;
        const bool any = update(data, bench, 100, 900, 1);
        ASSERT_EQ(any, bench.session.recorded() > 0);
        if (!any) continue;
        const std::uint32_t steps = bench.session.recorded();
        const auto lane = [&](Curve curve, std::uint32_t step) {
            return data.values[static_cast<std::size_t>(curve)][step - 1];
        };
        std::size_t before = 0;
        for (std::uint32_t step = 1; step <= steps; ++step) {
            go_to_step(bench, step);
            const std::size_t rendered = bench.session.counters().rendered_count;
            EXPECT_EQ(lane(Curve::visible, step) + lane(Curve::hidden, step), static_cast<double>(rendered - before));
            EXPECT_EQ(lane(Curve::front, step), bench.session.counters().front_size);
            EXPECT_EQ(data.by_primitives[step], rendered);
            EXPECT_TRUE(data.cell[step - 1] == none || data.step_of_cell[data.cell[step - 1]] == step);
            before = rendered;
        }
        for (std::size_t i = 0; i < data.spans.size(); ++i)
            for (const LaneSpan& span : data.spans[i]) {
                EXPECT_GE(span.low, data.lowest[i]);
                EXPECT_LE(span.high, data.highest[i]);
            }
        const std::size_t found = data.marks.size();
        bench.session.bookmarks.push_back({steps, "here"});
        bench.session.breakpoints = {{"step:1", true}, {"rho > 1", true}, {"step:999999", true}};
        bench.marked = {1, steps};
        update(data, bench, 100, 900, 1);
        EXPECT_EQ(data.marks.size(), found + 4);
        bench.desk.axis = TimelineAxis::primitives;
        update(data, bench, 100, 900, 1);
        EXPECT_EQ(data.axis.ends.data(), data.by_primitives.data());
        // Another run: everything anew.
        go_to_step(bench, 0);
        Settings settings = bench.session.settings();
        settings.method = settings.method == "everything" ? "published" : "everything";
        change_settings(bench, settings);
        update(data, bench, 100, 900, 1);
        EXPECT_EQ(data.cell.size(), bench.session.recorded());
    }
}

}  // namespace
}  // namespace sightline
