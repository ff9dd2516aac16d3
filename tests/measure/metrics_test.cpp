// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/metrics.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/session/session_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

Session<2> session_of(std::vector<Primitive<2>> segments, const ViewSpec<2>& view, Settings settings = {}) {
    auto scene = std::make_shared<Scene<2>>();
    scene->primitives = std::move(segments);
    return {scene, view, settings};
}

/// Eye at the origin, looking along +x over 90 degrees: at x the cone reaches from -x to x.
const ViewSpec<2> ahead{{0, 0}, {1, 0}, 90};

TEST(Metrics, AWallHidesTheWallBehindIt) {
    const Session<2> session = session_of({{Vec<2>(3, -2), Vec<2>(3, 2)}, {Vec<2>(1, -2), Vec<2>(1, 2)}}, ahead);
    const Reference& reference = session.reference();
    EXPECT_EQ(reference.visible, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(reference.count, 1u);
    EXPECT_EQ(reference.name, "exact");
    EXPECT_EQ(coverage(reference, 0), 0.0);
    EXPECT_EQ(coverage(reference, 1), 1.0);
    EXPECT_EQ(oracle(reference, 0), 0.0);
    EXPECT_EQ(oracle(reference, 1), 1.0);
    EXPECT_EQ(oracle(reference, 100), 1.0);
    const Met both[] = {{0, false}, {1, false}}, hidden[] = {{0, false}}, culled[] = {{1, true}};
    EXPECT_EQ(visible_rendered(reference, both), 1u);
    EXPECT_EQ(visible_rendered(reference, hidden), 0u);
    EXPECT_EQ(visible_rendered(reference, culled), 0u) << "met, but not rendered";
}

TEST(Metrics, AGapShowsWhatLiesBehindIt) {
    // Two wings with a gap of a third of the cone's width; behind the gap a wall, behind a wing a crate.
    const Session<2> session = session_of({{Vec<2>(1, -1), Vec<2>(1, -0.25)},
                                           {Vec<2>(1, 0.25), Vec<2>(1, 1)},
                                           {Vec<2>(2, -0.75), Vec<2>(2, 0.75)},
                                           {Vec<2>(3, 1.5), Vec<2>(3, 2)}},
                                          ahead);
    const Reference& reference = session.reference();
    EXPECT_EQ(reference.visible, (std::vector<std::uint8_t>{1, 1, 1, 0}));
    EXPECT_EQ(coverage(reference, 2), 2.0 / 3);
    EXPECT_EQ(oracle(reference, 2), 2.0 / 3);
    EXPECT_EQ(oracle(reference, 4), 1.0);
}

TEST(Metrics, SharesAreAngles) {
    // Tree cells over [0, 2]^2, cut once: the wall at x = 1.5 spans two cells, its parts 45 and atan(1/3) degrees.
    Settings settings;
    settings.tessellation = Tessellation::tree;
    settings.error_bound = 0.75;
    Session<2> session = session_of({{Vec<2>(1.5, 0), Vec<2>(1.5, 1.5)},
                                     {Vec<2>(0, 0), Vec<2>(-0.0, 2)},
                                     {Vec<2>(0, 2), Vec<2>(2, 2)},
                                     {Vec<2>(2, 0), Vec<2>(2, 0.5)}},
                                    {{0, 0.5}, {1, 0.5}, 120}, settings);
    ASSERT_EQ(session.cells().cell_count(), 4u);
    const auto share = [&](double x, double y) {
        return session.reference().cell_share[locate(session.cells(), Vec<2>(x, y))];
    };
    const double low = std::atan2(0.5, 1.5) + std::atan2(0.5, 1.5);   // y from 0 to 1 at x = 1.5
    const double high = std::atan2(1, 1.5) - std::atan2(0.5, 1.5);    // y from 1 to 1.5
    const double top = std::acos(-1.0) / 3 - std::atan2(1.5, 2);      // y = 2 from x = 2 up to 60 degrees
    const double from_top = std::atan2(1.5, 1) - std::atan2(1.5, 2);  // its part right of x = 1
    const double total = low + high + top;
    EXPECT_NEAR(share(1.75, 0.25), low / total, 1e-12);
    EXPECT_NEAR(share(1.75, 1.25), (high + from_top) / total, 1e-12);
    EXPECT_NEAR(share(0.25, 1.75), (top - from_top) / total, 1e-12);
    EXPECT_EQ(share(0.25, 0.25), 0);
}

/// Segments with random ends: none lies on the border of two cells.
std::vector<Primitive<2>> loose_segments(Random& random, std::size_t count) {
    std::vector<Primitive<2>> segments;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<2> at(random.unit(), random.unit());
        segments.push_back({at, at + Vec<2>(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3))});
    }
    return segments;
}

TEST(Metrics, SharesSumToOneAndAreWhatRaysFind) {
    Random random(51);
    for (int i = 0; i < test::soak_count(60); ++i) {
        Settings settings;
        settings.tessellation = random.below(2) ? Tessellation::tree : Tessellation::delaunay;
        settings.error_bound = 0.2;
        ViewSpec<2> view = test::random_view(random);
        view.eye += Vec<2>(0.0123, 0.0456);
        const Session<2> session = session_of(loose_segments(random, 1 + random.below(40)), view, settings);
        const auto& share = session.reference().cell_share;
        const double sum = std::accumulate(share.begin(), share.end(), 0.0);
        if (session.reference().count == 0) {
            ASSERT_EQ(sum, 0);
            continue;
        }
        ASSERT_NEAR(sum, 1, 1e-9);

        // Rays at equal angles; which cell holds the first hit?
        const int rays = 6000;
        std::vector<double> sampled(share.size());
        double hits = 0;
        const double middle = std::atan2(view.look_at.y - view.eye.y, view.look_at.x - view.eye.x);
        for (int r = 0; r < rays; ++r) {
            const double angle = middle + ((r + 0.5) / rays - 0.5) * view.fov * std::acos(-1.0) / 180;
            const Vec<2> d(std::cos(angle), std::sin(angle));
            double nearest = 1e300;
            for (const auto& [a, b] : session.scene().primitives) {
                const Vec<2> s = b - a;
                const double along = cross(a - view.eye, s) / cross(d, s), on = cross(a - view.eye, d) / cross(d, s);
                if (along > 0 && on >= 0 && on <= 1) nearest = std::min(nearest, along);
            }
            if (nearest == 1e300) continue;
            ++hits;
            const std::uint32_t cell = locate(session.cells(), view.eye + d * nearest);
            if (cell != none) ++sampled[cell];
        }
        ASSERT_GT(hits, 0);
        for (std::uint32_t cell = 0; cell < share.size(); ++cell) {
            // A cell is met in few intervals; each end is off by at most a ray.
            ASSERT_NEAR(share[cell], sampled[cell] / hits, 60 / hits + 1e-9) << "scene " << i << " cell " << cell;
            if (session.cells().count(cell) == 0) {
                ASSERT_EQ(share[cell], 0) << "an empty cell shows nothing";
            }
        }
    }
}

TEST(Metrics, NothingVisibleHasNoCoverage) {
    const Session<2> session = session_of({{Vec<2>(-1, -1), Vec<2>(-1, 1)}}, ahead);
    EXPECT_EQ(session.reference().count, 0u);
    EXPECT_FALSE(coverage(session.reference(), 0));
    EXPECT_FALSE(oracle(session.reference(), 5));
    EXPECT_FALSE(cell_oracle(session.reference(), session.problem()));
}

TEST(Metrics, TheCellOracleTakesCellsByTheirShare) {
    Random random(52);
    int below_oracle = 0;
    for (int i = 0; i < test::soak_count(300); ++i) {
        const test::Start start = test::random_cell_start(random);
        const Session<2> session = start.session();
        const Reference& reference = session.reference();
        const auto ours = cell_oracle(reference, session.problem());
        if (reference.count == 0) {
            ASSERT_FALSE(ours);
            continue;
        }
        std::vector<std::uint32_t> order(session.cells().cell_count());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](auto a, auto b) { return reference.cell_share[a] > reference.cell_share[b]; });
        const std::size_t budget = start.settings.budget.primitives(start.scene->primitives.size());
        const View<2> view = make_view(start.view);
        std::size_t spent = 0, found = 0;
        std::set<std::uint32_t> met;
        for (std::size_t k = 0; k < order.size() && spent <= budget; ++k)
            for (const std::uint32_t p : session.cells().primitives_of(order[k])) {
                if (met.contains(p)) continue;
                const bool culled = !in_view(view, start.scene->primitives[p]);
                spent += !culled || test::choice<CulledCost>(start.settings, culled_cost_row()) == CulledCost::charged;
                if (spent > budget) break;
                met.insert(p);
                found += !culled && reference.visible[p];
            }
        ASSERT_EQ(*ours, static_cast<double>(found) / static_cast<double>(reference.count)) << "scene " << i;
        ASSERT_LE(*ours, *oracle(reference, budget));
        below_oracle += *ours < *oracle(reference, budget);
    }
    EXPECT_GT(below_oracle, 5);
}

TEST(Metrics, InversionsAreThoseOfTheDefinition) {
    Random random(53);
    int mis_ranked = 0, unreached = 0;
    for (int i = 0; i < test::soak_count(300); ++i) {
        const test::Start start = test::random_start(random, 100);
        Session<2> session = start.session();
        const Reference& reference = session.reference();
        std::vector<Inversion> expected;
        for (;;) {
            const auto before = test::marks(session);
            const std::uint32_t touched = session.counters().touched_count;
            if (session.step() != Stop::none) break;
            const std::uint32_t cell = id_of(session.timeline().steps.back().item, Kind::cell);
            // "A hidden, non-empty cell projected while a visible one waited."
            if (cell == none || reference.cell_share[cell] > 0 || session.cells().primitives_of(cell).empty()) continue;
            Inversion found;
            found.step = session.position();
            found.cell = cell;
            for (const CellState waiting : {CellState::enqueued, CellState::clean}) {
                for (std::uint32_t c = 0; c < before.size(); ++c)
                    if (reference.cell_share[c] > 0 && before[c].state == waiting &&
                        (found.waiting == none || reference.cell_share[c] > reference.cell_share[found.waiting]))
                        found.waiting = c;
                if (found.waiting == none) continue;
                found.kind = waiting == CellState::clean ? Inversion::Kind::unreached : Inversion::Kind::mis_ranked;
                break;
            }
            if (found.waiting == none) continue;
            for (const std::uint32_t primitive : rendered_ids(session.met().subspan(touched)))
                found.wasted += !reference.visible[primitive];
            ++(found.kind == Inversion::Kind::unreached ? unreached : mis_ranked);
            expected.push_back(found);
        }
        std::stable_sort(expected.begin(), expected.end(), [](const Inversion& a, const Inversion& b) {
            return a.wasted != b.wasted ? a.wasted > b.wasted : a.step < b.step;
        });
        // They are those of the recording, wherever the session stands in it.
        session.seek(static_cast<std::uint32_t>(random.below(session.position() + 1)));
        const auto ours = session.inversions();
        ASSERT_EQ(ours.size(), expected.size()) << "scene " << i;
        for (std::size_t k = 0; k < ours.size(); ++k) {
            ASSERT_EQ(ours[k].step, expected[k].step) << "scene " << i;
            ASSERT_EQ(ours[k].cell, expected[k].cell);
            ASSERT_EQ(ours[k].kind, expected[k].kind);
            ASSERT_EQ(ours[k].waiting, expected[k].waiting);
            ASSERT_EQ(ours[k].wasted, expected[k].wasted);
        }
    }
    EXPECT_GT(mis_ranked, 50);
    EXPECT_GT(unreached, 50);
}

}  // namespace
}  // namespace sightline
