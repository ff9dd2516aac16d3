// cPLP: whatever the first method and its budget, what is nearest at a pixel is rendered in the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cplp/cplp.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/measure/metrics.h"
#include "core/methods/cells/cell_rules.h"
#include "core/methods/cells/rounds.h"
#include "core/session/session.h"
#include "core/space/outside.h"
#include "tests/run/cplp_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using test::CplpCase;
using test::exact_ids;
using test::random_cplp_case;

template <int D>
void nothing_is_missed(std::uint64_t seed, int count) {
    Random random(seed);
    const Method<D>& method = find_method<D>(method_table<D>(), "cplp");
    std::size_t rounds = 0, added = 0, hidden = 0, cut = 0;
    for (int i = 0; i < count; ++i) {
        SCOPED_TRACE(i);
        const CplpCase<D> made = random_cplp_case<D>(random);
        for (const char* text :
             {"cplp", "cplp first=layers", "cplp first='formula key=depth'", "cplp first=layers draws=winners",
              "cplp first=layers test=item", "cplp test=item tiles=off", "cplp test=item draws=winners"}) {
            const Problem<D> problem = made.problem(text);
            const std::unique_ptr<Run<D>> run = method.start(problem);
            std::uint32_t before = 0;
            while (!run->finished()) {
                ASSERT_EQ(run->misses(), Misses::may);
                const std::uint32_t spent = run->counters().spent;
                ASSERT_EQ(run->run(1), Stop::steps);
                if (spent >= problem.budget) added += run->counters().rendered_count - before;
                before = run->counters().rendered_count;
            }
            ASSERT_EQ(run->run(1), Stop::complete);
            ASSERT_EQ(run->misses(), Misses::none_at_this_resolution);
            const auto rendered = rendered_mask(run->met(), made.scene.primitives.size());
            for (const std::uint32_t id : exact_ids(made).ids)
                if (id != none) {
                    ASSERT_TRUE(rendered[id]) << text << ", primitive " << id;
                }
            cut += static_cast<std::size_t>(std::count(rendered.begin(), rendered.end(), 0)) > 0;
            // What is still in the front could change nothing; what is projected was seen.
            Screen<D> screen;
            screen.show(run->problem(), run->met(), run->counters().touched_count);
            for (std::uint32_t cell = 0; cell < made.cells.cell_count(); ++cell)
                if (run->mark(cell).state == CellState::enqueued) {
                    ++hidden;
                    ASSERT_FALSE(screen.seen_at(run->problem(), cell)) << cell;
                    ASSERT_EQ(run->why_waiting(cell_item(cell)).reason, "hidden");
                }
            ++rounds;
        }
    }
    EXPECT_GT(added, 100u);
    EXPECT_GT(hidden, 100u);
    EXPECT_GT(cut, rounds / 4);
}

TEST(Cplp, InThePlaneNothingThatAPixelShowsIsMissed) { nothing_is_missed<2>(81, test::soak_count(60)); }
TEST(Cplp, InSpaceNothingThatAPixelShowsIsMissed) { nothing_is_missed<3>(82, test::soak_count(25)); }

TEST(Cplp, AWallThatReachesBeyondTheLastCellIsNotMissed) {
    Random random(86);
    std::size_t beyond = 0;
    for (int i = 0; i < test::soak_count(200); ++i) {
        CplpCase<2> made = random_cplp_case<2>(random);
        made.settings.border = Border::none;
        made.settings.budget = {Budget::Kind::primitives, 2};
        made.cells = build_cells(made.scene, made.settings);
        const auto run = find_method<2>(method_table<2>(), "cplp").start(made.problem("cplp"));
        ASSERT_EQ(run->run(none), Stop::complete);
        const auto rendered = rendered_mask(run->met(), made.scene.primitives.size());
        for (const std::uint32_t id : exact_ids(made).ids)
            if (id != none) {
                ASSERT_TRUE(rendered[id]) << i << ", primitive " << id;
            }
        beyond += reaching_outside<2>(made.cells, made.scene.primitives).size();
    }
    EXPECT_GT(beyond, 100u);
}

TEST(Cplp, ARoundSaysWhatItTestedAndStepsThroughIt) {
    Random random(83);
    const Method<2>& method = find_method<2>(method_table<2>(), "cplp");
    std::size_t tests = 0, seen = 0;
    for (int i = 0; i < test::soak_count(40); ++i) {
        const CplpCase<2> made = random_cplp_case<2>(random);
        const test::Recorded<2> recorded = test::record_all(method, made.problem());
        const std::uint32_t first_test = made.settings.parameters.text(cplp_test_row()) == "item" ? 3 : 2;
        std::size_t here = 0;
        for (std::uint32_t step = 1; step <= recorded.timeline.size(); ++step) {
            const Step& record = recorded.timeline.steps[step - 1];
            if (record.item.kind != Kind::round) continue;
            const auto changes = recorded.timeline.changes_of(step);
            const auto looked = recorded.run->considered(record, changes, 3);
            ASSERT_EQ(recorded.run->substeps(record, changes), first_test + looked.size());
            std::size_t now = 0;
            for (const Change& change : changes) now += Rule{change.rule} == Rule::projected_now;
            std::size_t saw = 0;
            for (const Considered& test : looked) saw += Rule{test.rule} == Rule::tested_seen;
            ASSERT_EQ(saw, now) << "what is seen is projected, and nothing else";
            tests += looked.size();
            here += looked.size();
            seen += saw;
            // Each substep has one lit line.
            OwnRun<2> at = OwnRun<2>(recorded.run->clone());
            for (std::uint32_t substep = 0; substep < first_test + looked.size(); ++substep) {
                CodePlace place{&record, step, changes, 0, substep};
                std::size_t lit = 0;
                for (const CodeLine& line : at->code(place)) lit += line.lit;
                ASSERT_EQ(lit, 1u) << substep;
            }
        }
        ASSERT_EQ(recorded.run->tests(), here) << "all that was tested, and nothing twice";
    }
    EXPECT_GT(tests, 200u);
    EXPECT_GT(seen, 100u);
}

TEST(Cplp, NothingIsLostWhereTheBudgetEnds) {
    Random random(85);
    int lost_without = 0;
    for (int i = 0; i < test::soak_count(20); ++i) {
        const CplpCase<2> made = random_cplp_case<2>(random);
        Settings settings = made.settings;
        const auto marked = [&](const char* method) {
            settings.method = method;
            Session<2> session(std::make_shared<const Scene<2>>(made.scene), {made.view.eye, made.view.look_at, 90},
                               settings);
            session.run();
            const auto markers = session.markers();
            return std::any_of(markers.begin(), markers.end(),
                               [](const Marker& m) { return m.kind == Marker::Kind::first_wrong; });
        };
        lost_without += marked("published");
        EXPECT_FALSE(marked("cplp"));
    }
    EXPECT_GT(lost_without, 2);
}

TEST(Cplp, RefusesAFirstMethodWithoutCells) {
    Random random(84);
    const Method<2>& method = find_method<2>(method_table<2>(), "cplp");
    const CplpCase<2> made = random_cplp_case<2>(random);
    EXPECT_THROW(method.start(made.problem("cplp first=everything")), InputError);
}

}  // namespace
}  // namespace sightline
