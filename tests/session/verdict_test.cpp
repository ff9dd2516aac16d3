// What the program says of a cell is recomputed and run again: why it is not in the front, what holds it back, and what
// one change would do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/session/explain.h"
#include "core/space/cell_in_view.h"
#include "tests/session/session_3d_support.h"
#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

constexpr std::uint32_t far_away = 0xffffffffu;

/// Facets from each cell to the nearest one that can bring it into the front, over clean cells that may enter it:
/// outwards from those, where the program looks inwards from the cell.
template <int D>
std::vector<std::uint32_t> distances(const Session<D>& session, const std::vector<std::uint32_t>& sources) {
    const CellComplex<D>& cells = session.cells();
    std::vector<std::uint32_t> distance(cells.cell_count(), far_away), queue = sources;
    for (const std::uint32_t source : sources) distance[source] = 0;
    const bool all =
        session.problem().parameters.template choice<OutsideView>(outside_view_row()) == OutsideView::enqueue;
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (const HalfFacet& half : cells.facets_of(queue[i])) {
            const std::uint32_t n = half.neighbour;
            if (n == none || distance[n] != far_away || session.mark(n).state != CellState::clean) continue;
            if (!all && !cell_in_view(cells, session.problem().view, n)) continue;
            distance[n] = distance[queue[i]] + 1;
            queue.push_back(n);
        }
    return distance;
}

/// The cells that a run without a budget projects.
template <int D>
std::set<std::uint32_t> projected_in_the_end(Session<D> session) {
    Settings settings = session.settings();
    settings.budget = {};
    session.change(settings);
    session.run();
    std::set<std::uint32_t> cells;
    for (const Step& step : session.timeline().steps)
        if (step.item.kind == Kind::cell) cells.insert(step.item.id);
    return cells;
}

template <int D>
void check_absence(const Session<D>& session, std::map<std::string, int>& seen) {
    const CellComplex<D>& cells = session.cells();
    const bool add_after =
        session.problem().parameters.template choice<YesNo>(neighbours_before_break_row()) == YesNo::no;
    const std::uint32_t partial = add_after ? session.counters().partial_cell : none;
    std::vector<std::uint32_t> front;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        if (session.mark(cell).state == CellState::enqueued) front.push_back(cell);
    const auto from_front = distances(session, front);
    const auto from_partial = distances(session, partial == none ? std::vector<std::uint32_t>{} : std::vector{partial});
    const auto comes = projected_in_the_end(session);
    const bool unseen =
        session.problem().parameters.template choice<OutsideView>(outside_view_row()) == OutsideView::unseen;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        const Mark mark = session.mark(cell);
        const Verdict verdict = session.traversal().why_not(cell_item(cell));
        if (mark.state == CellState::projected || mark.state == CellState::enqueued) {
            ASSERT_FALSE(verdict);
            ASSERT_TRUE(comes.contains(cell));
            continue;
        }
        const std::string reason(verdict.reason);
        SCOPED_TRACE("cell " + std::to_string(cell) + ": " + verdict.sentence);
        ++seen[reason];
        const bool outside =
            mark.state == CellState::unseen || (unseen && !cell_in_view(cells, session.problem().view, cell));
        ASSERT_EQ(reason == "outside-view", outside);
        const bool never = outside || reason == "front-empty" || reason == "unreachable";
        ASSERT_EQ(comes.contains(cell), !never);
        if (never) {
            ASSERT_TRUE(outside || (from_front[cell] == far_away && from_partial[cell] == far_away));
            ASSERT_EQ(reason == "front-empty", !outside && front.empty() && partial == none);
            continue;
        }
        const std::uint32_t about = verdict.about.id;
        if (reason == "budget-before-neighbours") {
            ASSERT_EQ(about, partial);
            ASSERT_LE(from_partial[cell], from_front[cell]);
            continue;
        }
        ASSERT_LT(from_front[cell], from_partial[cell]);
        ASSERT_EQ(reason, from_front[cell] == 1 ? "no-neighbour-projected" : "front-far");
        // The cell that it names is as near as any, and the first of those.
        for (const std::uint32_t other : front) {
            const std::uint32_t d = distances(session, {other})[cell];
            if (other == about) {
                ASSERT_EQ(d, from_front[cell]);
            }
            if (d == from_front[cell] && other != about) {
                ASSERT_TRUE(comes_before(session.mark(about), session.mark(other)));
            }
        }
        ASSERT_NE(verdict.sentence.find("number " + std::to_string(rank_in_front(session, about)) + " in the front"),
                  std::string::npos);
    }
}

TEST(Verdicts, WhyACellIsNotInTheFrontIsSoInEveryRun) {
    Random random(61);
    std::map<std::string, int> seen;
    for (int i = 0; i < test::soak_count(120); ++i) {
        SCOPED_TRACE(i);
        Session<2> session = test::random_cell_start(random, 25).session();
        session.seek(random.below(3) == 0 ? none : static_cast<std::uint32_t>(random.below(20)));
        check_absence(session, seen);
        if (HasFatalFailure()) return;
    }
    for (int i = 0; i < test::soak_count(20); ++i) {
        SCOPED_TRACE(i);
        Session<3> session = test::random_start_3d(random, 20).session();
        session.seek(random.below(3) == 0 ? none : static_cast<std::uint32_t>(random.below(20)));
        check_absence(session, seen);
        if (HasFatalFailure()) return;
    }
    for (const char* reason : {"outside-view", "budget-before-neighbours", "no-neighbour-projected", "front-far"})
        EXPECT_GT(seen[reason], 20) << reason;
}

/// The step that projects a cell, or meets a primitive, of a run by a session of its own; 0: none.
template <int D>
std::uint32_t step_of(Session<D> session, const Settings& settings, const Item& item) {
    session.change(settings);
    session.run();
    for (std::uint32_t step = 1; step <= session.recorded(); ++step) {
        if (session.timeline().steps[step - 1].item == item && item.kind == Kind::cell) return step;
        if (item.kind != Kind::primitive) continue;
        const std::uint32_t from = session.timeline().before(step).touched_count,
                            to = session.timeline().after(step).touched_count;
        for (const Met met : session.met().subspan(from, to - from))
            if (met.primitive() == item.id) return step;
    }
    return 0;
}

template <int D>
void check_waiting(const Session<D>& session, std::map<std::string, int>& seen) {
    for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell) {
        const CellExplanation e = explain_cell(session, cell);
        if (e.rank == 0) {
            ASSERT_FALSE(e.lost);
            continue;
        }
        SCOPED_TRACE("cell " + std::to_string(cell) + ": " + e.verdict.sentence);
        const std::string reason(e.verdict.reason);
        ++seen[reason];
        ASSERT_EQ(reason == "first", e.rank == 1);
        if (e.rank == 1) {
            Session<D> next = session;
            if (next.step() == Stop::none) {
                ASSERT_EQ(last_cell(next), cell);
            }
            continue;
        }
        // Every key that any step computed for it.
        double lowest = e.mark.key;
        for (const ChainLink& link : e.reached) lowest = std::min(lowest, link.update.key->key);
        ASSERT_EQ(reason == "lost-key", lowest < e.mark.key);
        ASSERT_EQ(e.lost.has_value(), lowest < e.mark.key);
        if (!e.lost) continue;
        const LostKey& lost = *e.lost;
        ASSERT_EQ(lost.key, lowest);
        // Where that key went, as sessions that stand there show it.
        const Session<D> then = copy_at(session, lost.step), after = copy_at(session, lost.lost_in);
        if (lost.taken) {
            ASSERT_LT(lost.step, lost.lost_in);
            ASSERT_EQ(after.mark(cell).key, lost.instead);
            ASSERT_GT(lost.instead, lost.key);
            ASSERT_EQ(copy_at(session, lost.lost_in - 1).mark(cell).key, lost.key);
        } else {
            ASSERT_EQ(lost.step, lost.lost_in);
            ASSERT_EQ(then.mark(cell).key, lost.instead);
        }
        const ParameterRow* row = session.method().parameter("on_reenqueue");
        ASSERT_EQ(lost.with_min.has_value(), row != nullptr);
        if (!row) continue;
        Settings with_min = session.settings();
        apply_setting(with_min, "on_reenqueue=min");
        ASSERT_EQ(lost.with_min->step, step_of(session, with_min, cell_item(cell)));
        const std::string wanted = lost.with_min->step > 0 ? "projected in step " + std::to_string(lost.with_min->step)
                                                           : "not have been projected either";
        ASSERT_TRUE(e.verdict.sentence.ends_with(wanted));
    }
}

TEST(Verdicts, WhatHoldsACellBackNamesTheRuleThatThrewALowerKeyAway) {
    Random random(62);
    std::map<std::string, int> seen;
    for (int i = 0; i < test::soak_count(60); ++i) {
        SCOPED_TRACE(i);
        Session<2> session = test::random_cell_start(random, 25).session();
        session.seek(static_cast<std::uint32_t>(1 + random.below(20)));
        check_waiting(session, seen);
        if (HasFatalFailure()) return;
    }
    for (int i = 0; i < test::soak_count(10); ++i) {
        SCOPED_TRACE(i);
        Session<3> session = test::random_start_3d(random, 20).session();
        session.seek(static_cast<std::uint32_t>(1 + random.below(20)));
        check_waiting(session, seen);
        if (HasFatalFailure()) return;
    }
    for (const char* reason : {"first", "lost-key", "key"}) EXPECT_GT(seen[reason], 10) << reason;
}

template <int D>
void check_changes(const Session<D>& session, const Item& item, int& sooner, int& never) {
    const Counterfactuals all = counterfactuals(session, item, true);
    ASSERT_EQ(all.now.step, step_of(session, session.settings(), item));
    std::set<std::string> changes;
    for (std::size_t i = 0; i < all.changes.size(); ++i) {
        const auto& [change, outcome] = all.changes[i];
        SCOPED_TRACE(change);
        ASSERT_TRUE(changes.insert(change).second);
        Settings settings = session.settings();
        apply_setting(settings, change);
        ASSERT_NE(settings, session.settings());
        ASSERT_EQ(outcome.step, step_of(session, settings, item));
        sooner += outcome.step > 0 && (all.now.step == 0 || outcome.step < all.now.step);
        never += outcome.step == 0;
        if (i > 0 && outcome.step > 0) {
            ASSERT_LE(all.changes[i - 1].outcome.step, outcome.step);
        }
    }
    // Every other word of every choice is there.
    for (const ParameterRow* row : session.method().parameters)
        for (const std::string_view word : row->words)
            ASSERT_EQ(changes.contains(std::string(row->name) + "=" + std::string(word)),
                      word != session.problem().parameters.text(*row))
                << row->name << " " << word;
    ASSERT_EQ(changes.contains("budget=unlimited"), session.problem().budget < session.scene().primitives.size());
}

TEST(Verdicts, EachSingleChangeDoesWhatIsSaidInARunOfItsOwn) {
    Random random(63);
    int sooner = 0, never = 0;
    const auto check = [&](auto session) {
        const auto primitives = session.scene().primitives.size();
        session.seek(static_cast<std::uint32_t>(random.below(10)));
        if (primitives > 0)
            check_changes(session, primitive_item(static_cast<std::uint32_t>(random.below(primitives))), sooner, never);
        if (session.method().orders_cells() && !testing::Test::HasFatalFailure())
            check_changes(session, cell_item(static_cast<std::uint32_t>(random.below(session.cells().cell_count()))),
                          sooner, never);
    };
    for (int i = 0; i < test::soak_count(40); ++i) {
        SCOPED_TRACE(i);
        check(test::random_start(random, 25).session());
        if (HasFatalFailure()) return;
    }
    for (int i = 0; i < test::soak_count(8); ++i) {
        SCOPED_TRACE(i);
        check(test::random_start_3d(random, 20).session());
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(sooner, 50);
    EXPECT_GT(never, 50);
}

}  // namespace
}  // namespace sightline
