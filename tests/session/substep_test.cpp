// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/substep.h"

#include <gtest/gtest.h>

#include <set>

#include "core/session/explain.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

std::set<std::uint32_t> rendered(const Session<2>& session) {
    const std::vector<std::uint32_t> ids = rendered_ids(session.met());
    return {ids.begin(), ids.end()};
}

/// Primitives that the run counts as met, by its own marks of them.
std::set<std::uint32_t> met(const Session<2>& session) {
    std::set<std::uint32_t> primitives;
    for (std::uint32_t p = 0; p < session.scene().primitives.size(); ++p)
        if (session.traversal().drawn().has(p)) primitives.insert(p);
    return primitives;
}

TEST(Substep, MarksChangeFacetByFacet) {
    Random random(61);
    int changed = 0, walked_back = 0;
    for (int i = 0; i < test::soak_count(150); ++i) {
        const test::Start start = test::random_cell_start(random);
        Session<2> session = start.session();
        const bool recorded_before = random.below(2) == 0;
        if (recorded_before) {
            session.run();
            session.seek(0);
        }
        for (;;) {
            const auto before = test::marks(session);
            const auto rendered_before = rendered(session), met_before = met(session);
            const Counters counters_before = session.counters();
            if (session.step() != Stop::none) break;
            const auto after = test::marks(session);
            const std::uint64_t hash = session.hash();
            const std::uint32_t step = session.position(), count = substep_count(session, step);
            const std::uint32_t cell = session.timeline().steps[step - 1].item.id;
            const auto facets = session.cells().facets_of(cell);
            ASSERT_TRUE(count == 2 || count == 2 + facets.size());

            auto expected = before;
            expected[cell] = after[cell];  // popped
            for (std::uint32_t substep = 0; substep < count; ++substep) {
                if (substep >= 2 && facets[substep - 2].neighbour != none) {
                    const std::uint32_t n = facets[substep - 2].neighbour;
                    changed += expected[n] != after[n];
                    expected[n] = after[n];
                }
                const Session<2> middle = session.in_the_middle(substep);
                ASSERT_EQ(test::marks(middle), expected) << "scene " << i << " step " << step << "." << substep;
                ASSERT_EQ(middle.position(), step);
                ASSERT_EQ(middle.recorded(), session.recorded());
                ASSERT_EQ(middle.counters().front_size, test::sorted_front(expected).size());
                std::uint32_t stamps = counters_before.next_stamp;
                for (const Mark& mark : expected)
                    if (mark.state == CellState::enqueued) stamps = std::max(stamps, mark.stamp + 1);
                ASSERT_EQ(middle.counters().next_stamp, stamps);
                const bool popped_only = substep == 0;
                ASSERT_EQ(rendered(middle), popped_only ? rendered_before : rendered(session));
                ASSERT_EQ(met(middle), popped_only ? met_before : met(session));
                const Counters& counted = popped_only ? counters_before : session.counters();
                ASSERT_EQ(middle.counters().rendered_count, counted.rendered_count);
                ASSERT_EQ(middle.counters().touched_count, counted.touched_count);
                ASSERT_EQ(middle.counters().spent, counted.spent);
                // What is told is what is done; later steps are told as ever.
                const StepExplanation told = explain_step(middle, step);
                ASSERT_EQ(told.rendered, counted.rendered_count - counters_before.rendered_count);
                ASSERT_EQ(told.looked_at.size(), substep < 2 ? 0 : substep - 1);
                for (const Considered& facet : told.looked_at)
                    if (Rule{facet.rule} == Rule::enqueued || Rule{facet.rule} == Rule::reenqueued) {
                        ASSERT_EQ(facet.key->key, expected[facet.item.id].key);
                    }
                if (middle.recorded() > step) {
                    const auto a = middle.timeline().changes_of(step + 1), b = session.timeline().changes_of(step + 1);
                    ASSERT_EQ(a.size(), b.size());
                    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_EQ(a[k].rule, b[k].rule);
                }
                if (substep + 1 == count) {
                    ASSERT_EQ(middle.hash(), hash);
                }
                if (random.below(20) == 0) {  // a copy may go back, as any session may
                    Session<2> back = middle;
                    ASSERT_TRUE(back.back());
                    ASSERT_EQ(test::marks(back), before);
                    ++walked_back;
                }
            }
            // The original walks as if nobody had looked.
            ASSERT_EQ(session.hash(), hash);
            session.back();
            ASSERT_EQ(test::marks(session), before);
            session.step();
            ASSERT_EQ(session.hash(), hash);
        }
    }
    EXPECT_GT(changed, 1000);
    EXPECT_GT(walked_back, 100);
}

TEST(Substep, OrdersOfPrimitivesPopAndRender) {
    Random random(62);
    int steps = 0;
    for (int i = 0; i < test::soak_count(60); ++i) {
        test::Start start = test::random_start(random, 200);
        start.settings.method = "centroid";
        Session<2> session = start.session();
        for (;;) {
            const auto before = rendered(session);
            const std::uint64_t hash_before = session.hash();
            if (session.step() != Stop::none) break;
            ASSERT_EQ(substep_count(session, session.position()), 2u);
            Session<2> popped = session.in_the_middle(0);
            ASSERT_EQ(rendered(popped), before);
            ASSERT_EQ(session.in_the_middle(1).hash(), session.hash());
            popped.back();
            ASSERT_EQ(popped.hash(), hash_before);
            ++steps;
        }
    }
    EXPECT_GT(steps, 50);
}

/// A neighbour across two facets of one cell does not occur in 2D, but nothing forbids it: what a step recorded there
/// would otherwise be put back in the wrong order.
TEST(Substep, NoCellMeetsANeighbourTwice) {
    Random random(63);
    for (int i = 0; i < test::soak_count(200); ++i) {
        const Session<2> session = test::random_start(random).session();
        for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
            std::set<std::uint32_t> seen;
            for (const HalfFacet& half : session.cells().facets_of(cell))
                if (half.neighbour != none) {
                    ASSERT_TRUE(seen.insert(half.neighbour).second);
                }
        }
    }
}

TEST(Substep, AtTheStartThereIsNothingToShow) {
    Random random(64);
    const Session<2> session = test::random_cell_start(random).session();
    EXPECT_EQ(session.in_the_middle(0).hash(), session.hash());
}

}  // namespace
}  // namespace sightline
