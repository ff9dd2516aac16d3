// Every measure of a frame: values that can be worked out by hand, and one run against runs with a budget.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/frame_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "core/measure/frame_change.h"
#include "core/measure/frame_clock.h"
#include "core/measure/wrong_region.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using M = Measure;
using Set = std::vector<std::uint8_t>;
constexpr std::uint32_t X = none;

/// Six primitives; an image of 4 x 2 pixels shows 0 three times, 1 twice and 4 once, two pixels are empty.
/// Layers: 0, 1 and 4 are visible, 2 and 3 lie in layers 2 and 3, nothing is known of 5.
Truth hand_made_truth() {
    Truth truth;
    truth.reference.visible = {1, 1, 0, 0, 1, 0};
    truth.reference.count = 3;
    truth.reference.image = {4, 2, {0, 0, 1, X, 0, 4, 1, X}};
    truth.reference.pixels = {3, 2, 0, 0, 1, 0};
    truth.zeta = std::make_shared<const std::vector<std::uint32_t>>(std::vector<std::uint32_t>{1, 1, 2, 3, 1, 0});
    return truth;
}

/// Steps: {2}, {} (an empty cell), {1, 5 culled, 3}, {0, 4}. The front grows to 7 and shrinks.
WholeRun hand_made_run() {
    WholeRun run;
    run.met = {{2, false}, {1, false}, {5, true}, {3, false}, {0, false}, {4, false}};
    run.touched_after = {1, 1, 4, 6};
    run.largest_front = {3, 5, 7, 7};
    run.inversions = {{1, 10, Inversion::Kind::mis_ranked, 11, 1},
                      {3, 12, Inversion::Kind::unreached, 13, 1},
                      {3, 14, Inversion::Kind::mis_ranked, 13, 0}};
    run.k95 = 5;
    run.tests_after = {0, 4, 12, 13};
    run.rounds_after = {0, 1, 2, 2};
    return run;
}

Values numbers(std::uint32_t budget, std::optional<double> best_cells = 0.5) {
    const Truth truth = hand_made_truth();
    const WholeRun run = hand_made_run();
    const Set rendered = rendered_by(run, cut_at(run, budget).met, 6);
    return frame_numbers(run, truth, budget, rendered, wrong_mask(truth.reference.image, rendered), best_cells);
}

TEST(FrameNumbers, AreThoseWorkedOutByHand) {
    const Values v = numbers(3);  // renders 2, 1 and 3
    EXPECT_EQ(v[M::budget], 3);
    EXPECT_EQ(v[M::rendered], 3);
    EXPECT_EQ(v[M::visible], 3);
    EXPECT_DOUBLE_EQ(v[M::coverage], 1 / 3.0) << "1 of 0, 1 and 4";
    EXPECT_DOUBLE_EQ(v[M::coverage_px], 2 / 6.0) << "two of six pixels that show something show 1";
    EXPECT_DOUBLE_EQ(v[M::oracle], 1.0);
    EXPECT_DOUBLE_EQ(v[M::cell_oracle], 0.5);
    EXPECT_DOUBLE_EQ(v[M::wrong], 4 / 8.0) << "three pixels of 0, one of 4; empty ones are right";
    EXPECT_DOUBLE_EQ(v[M::blob], 4 / 8.0) << "0 0 . . / 0 4 . . hang together";
    EXPECT_DOUBLE_EQ(v[M::k95], 5 / 6.0);
    EXPECT_DOUBLE_EQ(v[M::efficiency], 1 / 3.0);
    EXPECT_EQ(v[M::mis_ranked], 2);
    EXPECT_EQ(v[M::unreached], 1);
    EXPECT_DOUBLE_EQ(v[M::zeta], (2 + 1 + 3) / 3.0);
    EXPECT_EQ(v[M::steps], 3);
    EXPECT_EQ(v[M::front], 7);
    EXPECT_DOUBLE_EQ(v[M::emitted_over_visible], 1) << "three drawn, three visible";
    EXPECT_EQ(v[M::tested], 12) << "by the third step";
    EXPECT_EQ(v[M::rounds], 2);
    for (const M other : {M::pop, M::flip, M::visible_change, M::traverse_ms, M::upload_ms, M::draw_ms, M::total_ms})
        EXPECT_TRUE(std::isnan(v[other])) << measure_row(other).id << " needs another frame or a clock";
}

TEST(FrameNumbers, OfABudgetThatCutsAStepCountThatStep) {
    const Values two = numbers(2);  // 2 and 1
    EXPECT_EQ(two[M::steps], 3);
    EXPECT_DOUBLE_EQ(two[M::oracle], 2 / 3.0);
    EXPECT_DOUBLE_EQ(two[M::zeta], 1.5);
    const Values one = numbers(1);
    EXPECT_EQ(one[M::steps], 1) << "the empty cell behind it is not reached";
    EXPECT_EQ(one[M::front], 3);
    EXPECT_EQ(one[M::mis_ranked], 1);
    EXPECT_EQ(one[M::unreached], 0);
    EXPECT_EQ(one[M::coverage], 0);
    EXPECT_DOUBLE_EQ(one[M::wrong], 6 / 8.0);
    EXPECT_DOUBLE_EQ(one[M::blob], 6 / 8.0) << "all six hang together";
    const Values none = numbers(0, std::nullopt);
    EXPECT_EQ(none[M::rendered], 0);
    EXPECT_EQ(none[M::steps], 0);
    EXPECT_EQ(none[M::front], 0);
    EXPECT_TRUE(std::isnan(none[M::efficiency]));
    EXPECT_TRUE(std::isnan(none[M::zeta]));
    EXPECT_TRUE(std::isnan(none[M::cell_oracle]));
    const Values all = numbers(100);
    EXPECT_EQ(all[M::rendered], 5);
    EXPECT_EQ(all[M::coverage], 1);
    EXPECT_EQ(all[M::coverage_px], 1);
    EXPECT_EQ(all[M::wrong], 0);
    EXPECT_EQ(all[M::blob], 0);
    EXPECT_EQ(all[M::steps], 4);
    EXPECT_DOUBLE_EQ(all[M::efficiency], 3 / 5.0);
}

TEST(FrameNumbers, WithCulledPrimitivesAtACostEndEarlier) {
    WholeRun run = hand_made_run();
    run.culled_costs = true;
    EXPECT_EQ(cut_at(run, 3).met, 3u);
    run.culled_costs = false;
    EXPECT_EQ(cut_at(run, 3).met, 4u);
}

TEST(FrameNumbers, OfWholeCellsEndWhereTheirStepDoes) {
    WholeRun run = hand_made_run();
    run.spent_after = {2, 2, 7, 9};
    EXPECT_EQ(cut_at(run, 0).steps, 0u);
    EXPECT_EQ(cut_at(run, 2).steps, 1u);
    EXPECT_EQ(cut_at(run, 3).steps, 3u);
    EXPECT_EQ(cut_at(run, 3).met, 4u);
    EXPECT_EQ(cut_at(run, 9).met, 6u);
    EXPECT_EQ(cut_at(run, 100).steps, 4u);
}

TEST(FrameNumbers, CountStepsWithKey0) {
    const Truth truth = hand_made_truth();
    WholeRun run = hand_made_run();
    const auto share = [&](std::uint32_t budget) {
        const Set rendered = rendered_by(run, cut_at(run, budget).met, 6);
        return frame_numbers(run, truth, budget, rendered, wrong_mask(truth.reference.image, rendered),
                             0.5)[M::zero_keys];
    };
    EXPECT_TRUE(std::isnan(share(3))) << "no cells were popped";
    run.zero_keys_after = {1, 2, 2, 3};
    EXPECT_DOUBLE_EQ(share(3), 2 / 3.0);
    EXPECT_DOUBLE_EQ(share(100), 3 / 4.0);
    EXPECT_TRUE(std::isnan(share(0)));
}

TEST(FrameNumbers, OfNothingVisibleHaveNoCoverage) {
    Truth truth = hand_made_truth();
    truth.reference.visible.assign(6, 0);
    truth.reference.count = 0;
    truth.reference.pixels.assign(6, 0);
    truth.reference.image.ids.assign(8, X);
    const WholeRun run = hand_made_run();
    const Set rendered = rendered_by(run, 6, 6);
    const Values v = frame_numbers(run, truth, 9, rendered, wrong_mask(truth.reference.image, rendered), std::nullopt);
    EXPECT_TRUE(std::isnan(v[M::coverage]));
    EXPECT_TRUE(std::isnan(v[M::coverage_px]));
    EXPECT_TRUE(std::isnan(v[M::oracle]));
    EXPECT_EQ(v[M::wrong], 0);
    EXPECT_EQ(v[M::efficiency], 0);
}

/// The state that a run with a budget leaves, by the steps of the viewer.
template <int D>
void expect_same_as_with_budget(const Session<D>& session, Random& random) {
    Problem<D> asked = session.problem();
    if (random.below(2)) asked.parameters.set(budget_counts_row(), "per_cell");
    const WholeRun run = whole_run<D>(session.method(), asked, session.reference());
    const std::size_t primitives = session.scene().primitives.size();
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<std::uint32_t>(random.below(primitives + 2));
        Problem<D> problem = asked;
        problem.budget = k;
        const test::Recorded<D> recorded = test::record_all(session.method(), problem);
        const Set rendered = rendered_mask(recorded.run->met(), primitives);
        const Cut cut = cut_at(run, k);
        EXPECT_EQ(rendered_by(run, cut.met, primitives), rendered) << session.method().id << " at " << k;
        // The papers' break makes the step that adds the neighbours one of its own, and a budget of 0 ends at the
        // start.
        if (test::choice<YesNo>(session.settings(), neighbours_before_break_row()) == YesNo::yes && k > 0 &&
            recorded.run->counters().spent > 0) {
            EXPECT_EQ(cut.steps, recorded.run->steps()) << session.method().id << " at " << k;
        }
    }
    if (run.k95) {
        EXPECT_GE(*run.k95, 1u);
        for (const std::uint32_t k : {*run.k95 - 1, *run.k95}) {
            std::size_t found = 0;
            std::uint32_t rendered = 0;
            for (const std::uint32_t primitive : rendered_ids(run.met))
                if (rendered < k) {
                    ++rendered;
                    found += session.reference().visible[primitive];
                }
            const bool enough = static_cast<double>(found) >= 0.95 * static_cast<double>(session.reference().count);
            EXPECT_EQ(enough, k == *run.k95);
        }
    }
}

TEST(FrameNumbers, OfOneRunAreThoseOfRunsWithABudget) {
    Random random(61);
    for (int i = 0; i < test::soak_count(60); ++i) {
        const test::Start start = test::random_start(random);
        expect_same_as_with_budget<2>(start.session(), random);
    }
    for (int i = 0; i < test::soak_count(25); ++i)
        expect_same_as_with_budget<3>(test::random_start_3d(random).session(), random);
}

TEST(WrongRegion, HangsTogetherBySidesOnly) {
    const Set mask{1, 0, 1, 1,   //
                   0, 1, 1, 0,   //
                   1, 0, 0, 1};  //
    EXPECT_EQ(largest_region(mask, 4, 3), 4u);
    EXPECT_EQ(largest_region(Set(12, 0), 4, 3), 0u);
    EXPECT_EQ(largest_region(Set(12, 1), 4, 3), 12u);
    EXPECT_EQ(largest_region(Set{1, 0, 0, 1}, 4, 1), 1u) << "rows do not wrap";
    EXPECT_EQ(largest_region({}, 0, 0), 0u);
}

/// Labels that the smaller of two neighbours hands on until nothing changes.
std::size_t largest_region_slowly(const Set& mask, int w, int h) {
    std::vector<int> label(mask.size());
    std::iota(label.begin(), label.end(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{0, 1}}) {
                    if (x + dx >= w || y + dy >= h) continue;
                    const auto a = static_cast<std::size_t>(y * w + x),
                               b = static_cast<std::size_t>((y + dy) * w + x + dx);
                    if (!mask[a] || !mask[b] || label[a] == label[b]) continue;
                    label[a] = label[b] = std::min(label[a], label[b]);
                    changed = true;
                }
    }
    std::vector<std::size_t> size(mask.size());
    std::size_t largest = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i]) largest = std::max(largest, ++size[static_cast<std::size_t>(label[i])]);
    return largest;
}

TEST(WrongRegion, IsThatOfASlowSearch) {
    Random random(62);
    for (int i = 0; i < test::soak_count(200); ++i) {
        const int w = 1 + static_cast<int>(random.below(9)), h = 1 + static_cast<int>(random.below(9));
        Set mask(static_cast<std::size_t>(w * h));
        for (auto& m : mask) m = random.below(5) < 3;
        EXPECT_EQ(largest_region(mask, w, h), largest_region_slowly(mask, w, h));
        const auto regions = wrong_regions({w, h, std::vector<std::uint32_t>(mask.size(), 0)}, mask);
        EXPECT_EQ(regions.empty() ? 0 : regions.front().pixels, largest_region_slowly(mask, w, h));
    }
}

TEST(FrameChange, IsThatWorkedOutByHand) {
    EXPECT_DOUBLE_EQ(jaccard(Set{1, 1, 0, 0}, Set{1, 0, 1, 0}), 1 / 3.0);
    EXPECT_DOUBLE_EQ(jaccard(Set{0, 0}, Set{0, 0}), 1);
    EXPECT_DOUBLE_EQ(difference(Set{1, 1, 0, 0}, Set{1, 0, 1, 0}), 0.5);
    EXPECT_DOUBLE_EQ(difference(Set{}, Set{}), 0);
    // Visible in both: 0, 1, 2. Of these 1 appears and 2 goes; what happens to 3 and 4 the exact set explains.
    const Set visible_before{1, 1, 1, 1, 0}, visible{1, 1, 1, 0, 1};
    const Set before{1, 0, 1, 1, 0}, after{1, 1, 0, 0, 1};
    EXPECT_DOUBLE_EQ(*pop(visible_before, before, visible, after), 2 / 3.0);
    EXPECT_DOUBLE_EQ(*pop(visible_before, before, visible_before, before), 0);
    EXPECT_FALSE(pop(Set{1, 0}, Set{1, 0}, Set{0, 1}, Set{0, 1}));
}

TEST(MeasureTable, HasARowForEachMeasureInItsPlace) {
    ASSERT_EQ(measure_table().size(), measure_count);
    std::set<std::string_view> ids;
    for (std::size_t i = 0; i < measure_count; ++i) {
        const MeasureRow& row = measure_table()[i];
        EXPECT_EQ(static_cast<std::size_t>(row.measure), i);
        EXPECT_TRUE(ids.insert(row.id).second) << row.id;
        EXPECT_FALSE(row.formula.empty() || row.unit.empty() || row.title.empty() || row.source.empty()) << row.id;
        EXPECT_EQ(row.is_time, row.unit == "ms" || row.measure == M::over_exact) << row.id;
    }
}

TEST(FrameClock, SumsUpRepeats) {
    Values values;
    set_times({{3, 1, 2}, {0.5, 0.1, 0.3}, {9, 9, 12}}, values);
    EXPECT_EQ(values[M::traverse_ms], 2);
    EXPECT_EQ(values[M::upload_ms], 0.3);
    EXPECT_EQ(values[M::draw_ms], 9);
    EXPECT_DOUBLE_EQ(values[M::total_ms], 11.3);
    EXPECT_DOUBLE_EQ(values[M::traverse_error], 1 / std::sqrt(3));
    EXPECT_DOUBLE_EQ(values[M::upload_error], 0.2 / std::sqrt(3));
    EXPECT_DOUBLE_EQ(values[M::draw_error], std::sqrt(3.0) / std::sqrt(3));
    EXPECT_DOUBLE_EQ(values[M::total_error], std::sqrt((1 + 0.04 + 3) / 3));
    Values in_2d;
    set_times({{4}, {}, {}}, in_2d);
    EXPECT_EQ(in_2d[M::total_ms], 4);
    EXPECT_TRUE(std::isnan(in_2d[M::draw_ms]) && std::isnan(in_2d[M::draw_error]));
    EXPECT_TRUE(std::isnan(in_2d[M::traverse_error])) << "once says nothing of the error";
    Values drawing_alone;
    set_times({{}, {1}, {2}}, drawing_alone);
    EXPECT_EQ(drawing_alone[M::total_ms], 3);
    EXPECT_TRUE(std::isnan(drawing_alone[M::traverse_ms]));
    Values nothing;
    set_times({}, nothing);
    EXPECT_TRUE(std::isnan(nothing[M::total_ms]));
    for (const MeasureRow& row : measure_table())
        EXPECT_EQ(error_of(row.measure).has_value(), row.is_time && row.better == Better::lower) << row.id;
}

}  // namespace
}  // namespace sightline
