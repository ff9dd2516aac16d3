// The marks of lost pixels: the first one of a run, and pops between two frames.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/first_wrong.h"

#include <gtest/gtest.h>

#include "core/measure/frame_change.h"
#include "core/measure/frame_numbers.h"
#include "core/session/pops.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using namespace test;

/// The best number of visible primitives that a run can still end with.
template <int D>
std::size_t best_end(const Session<D>& session, std::uint32_t budget) {
    const std::size_t found = session.visible_rendered(), left = budget - std::min(budget, session.counters().spent);
    return std::min(session.reference().count, found + left);
}

template <int D>
void check(Session<D> session, std::array<int, 2>& seen) {
    const std::uint32_t budget = session.problem().budget;
    session.run();
    const auto lost = first_wrong(session.reference(), session.met(), session.timeline(), budget);
    const std::size_t at_best = std::min<std::size_t>(session.reference().count, budget);
    if (session.counters().spent >= budget) {
        ASSERT_EQ(lost.has_value(), session.visible_rendered() < at_best) << "marked without a loss, or the reverse";
    }
    ++seen[lost.has_value()];
    if (!lost) return;
    ASSERT_GT(lost->step, 0u);
    session.seek(lost->step);
    ASSERT_LT(best_end(session, budget), at_best);
    ASSERT_EQ(lost->missing, session.reference().count - session.visible_rendered());
    ASSERT_EQ(lost->left, budget - session.counters().spent);
    session.seek(lost->step - 1);
    ASSERT_EQ(best_end(session, budget), at_best) << "the step before lost it already";
}

TEST(FirstWrong, IsTheStepBehindWhichNoOrderReachesTheOracle) {
    Random random(91);
    std::array<int, 2> flat{}, solid{};
    for (int i = 0; i < test::soak_count(150); ++i) {
        Start start = random_start(random, 120);
        start.settings.budget = {Budget::Kind::primitives, static_cast<double>(1 + random.below(60))};
        check<2>(start.session(), flat);
        Start3 start3 = random_start_3d(random);
        start3.settings.budget = {Budget::Kind::primitives, static_cast<double>(1 + random.below(30))};
        check<3>(start3.session(), solid);
    }
    for (const int count : {flat[0], flat[1], solid[0], solid[1]}) EXPECT_GT(count, 5);
}

TEST(FirstWrong, IsNeverThereWithoutABudget) {
    Random random(92);
    for (int i = 0; i < test::soak_count(20); ++i) {
        Start start = random_start(random, 80);
        start.settings.budget = {};
        Session<2> session = start.session();
        session.run();
        EXPECT_FALSE(first_wrong(session.reference(), session.met(), session.timeline(), session.problem().budget));
    }
}

TEST(Pops, CountWhatTheMeasureOfPoppingCounts) {
    Random random(93);
    std::size_t appearing = 0, vanishing = 0;
    for (int i = 0; i < test::soak_count(400); ++i) {
        Start start = random_start(random, 120);
        start.settings.budget = {Budget::Kind::primitives, static_cast<double>(1 + random.below(30))};
        ViewSpec<2> before = start.view;
        before.eye += Vec<2>(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
        Session<2> now = start.session();
        // The truth by another way: prefixes of whole runs.
        const auto set_of = [&](const ViewSpec<2>& view, std::vector<std::uint8_t>& visible) {
            const Problem<2> problem = test::problem_of(*start.scene, now.cells(), make_view(view), start.settings);
            const Reference reference = exact_reference(start.scene->primitives, now.cells(), problem.view);
            const WholeRun run = whole_run<2>(now.method(), problem, reference, false);
            visible = reference.visible;
            return rendered_by(run, cut_at(run, problem.budget).met, visible.size());
        };
        std::vector<std::uint8_t> visible_before, visible;
        const auto rendered_before = set_of(before, visible_before), rendered = set_of(start.view, visible);
        std::size_t appear = 0, vanish = 0;
        for (std::size_t p = 0; p < visible.size(); ++p)
            if (visible[p] && visible_before[p]) {
                appear += rendered[p] && !rendered_before[p];
                vanish += !rendered[p] && rendered_before[p];
            }

        now.seek(static_cast<std::uint32_t>(random.below(20)));  // wherever it stands
        const std::uint64_t hash = now.hash();
        std::size_t marked = 0, marked_end = 0;
        Session<2> end = now;
        end.run();
        for (const Marker& marker : pop_markers(now, before)) {
            ASSERT_EQ(marker.kind, Marker::Kind::pop);
            ASSERT_GE(marker.step, 1u);
            ASSERT_LE(marker.step, end.position());
            const bool vanishes = marker.label.find("vanish") != std::string::npos;
            (vanishes ? marked_end : marked) += std::stoul(marker.label);
            if (vanishes) {
                ASSERT_EQ(marker.step, end.position());
                continue;
            }
            std::size_t in_step = 0;
            const std::uint32_t first = end.timeline().before(marker.step).touched_count;
            for (const std::uint32_t p :
                 rendered_ids(end.met().subspan(first, end.timeline().after(marker.step).touched_count - first)))
                in_step += visible[p] && visible_before[p] && !rendered_before[p];
            ASSERT_EQ(in_step, std::stoul(marker.label));
        }
        ASSERT_EQ(now.hash(), hash);
        ASSERT_EQ(marked, appear);
        if (end.position() > 0) {
            ASSERT_EQ(marked_end, vanish);
        }
        appearing += appear;
        vanishing += vanish;
    }
    EXPECT_GT(appearing, 20u);
    EXPECT_GT(vanishing, 20u);
}

}  // namespace
}  // namespace sightline
