// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/trig.h"
#include "core/space/builders.h"
#include "core/traversal/methods.h"
#include "tests/run/reference_traversal.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

std::vector<std::uint32_t> popped_cells(const Timeline& timeline) {
    std::vector<std::uint32_t> cells;
    for (const StepRecord& step : timeline.steps) cells.push_back(step.cell);
    return cells;
}

/// Runs recorded from the start until something stops it.
template <int D>
Timeline record_all(const Method<D>& method, const Frame<D>& frame, State<D>& state) {
    Timeline timeline;
    method.start(frame, state);
    timeline.seed_count = state.front_size;
    while (method.record(frame, state, timeline) == Stop::none) {
    }
    return timeline;
}

TEST(Traversal, OrderIsThatOfThePapersStructure) {
    Random random(11);
    for (int i = 0; i < test::soak_count(400); ++i) {
        const Scene<2> scene = test::random_scene(random, 5 + random.below(120));
        Settings settings;
        settings.tessellation = random.below(2) ? Tessellation::delaunay : Tessellation::tree;
        settings.jitter = random.below(2) ? 0.02 : 0;
        if (random.below(2)) settings.budget = {Budget::Kind::primitives, static_cast<double>(random.below(100))};
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        const Frame<2> frame = make_frame<2>(scene.primitives, cells, view, settings);
        State<2> state;
        const Timeline timeline = record_all(find_method<2>(method_table<2>(), "published"), frame, state);

        std::vector<std::uint32_t> projected, rendered;
        if (frame.budget > 0)
            test::PaperTraversal(scene, cells).run(view, seed_cells(frame).front(), frame.budget, projected, rendered);
        ASSERT_EQ(popped_cells(timeline), projected) << "scene " << i;
        std::vector<std::uint32_t> ours;
        for (const std::uint32_t entry : state.touched)
            if (!(entry & State<2>::culled_bit)) ours.push_back(entry);
        ASSERT_EQ(ours, rendered) << "scene " << i;
    }
}

/// The gem's layers are the rings of a breadth-first search over cells in view.
TEST(Traversal, LayersPopCellsBreadthFirst) {
    Random random(19);
    for (int i = 0; i < test::soak_count(200); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        Settings settings = test::random_settings(random);
        settings.outside_view = OutsideView::unseen;
        settings.budget = {};
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        const Frame<2> frame = make_frame<2>(scene.primitives, cells, view, settings);
        State<2> state;
        const Timeline timeline = record_all(find_method<2>(method_table<2>(), "layers"), frame, state);

        std::vector<std::uint32_t> queue = seed_cells(frame);
        std::vector<std::uint8_t> seen(cells.cell_count());
        for (const std::uint32_t seed : queue) seen[seed] = 1;
        for (std::size_t next = 0; next < queue.size(); ++next)
            for (const HalfFacet& half : cells.facets_of(queue[next])) {
                if (half.neighbour == none || seen[half.neighbour]) continue;
                seen[half.neighbour] = 1;
                if (cell_in_view(cells, view, half.neighbour)) queue.push_back(half.neighbour);
            }
        ASSERT_EQ(popped_cells(timeline), queue) << "scene " << i;
    }
}

TEST(Traversal, CentroidOrderIsByDistanceAndCullsTheView) {
    Random random(20);
    for (int i = 0; i < test::soak_count(100); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        const Settings settings;
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        State<2> state;
        record_all(find_method<2>(method_table<2>(), "centroid"),
                   make_frame<2>(scene.primitives, cells, view, settings), state);
        ASSERT_EQ(state.touched.size(), scene.primitives.size());
        double last = 0;
        for (const std::uint32_t entry : state.touched) {
            const Primitive<2>& p = scene.primitives[entry & ~State<2>::culled_bit];
            const double distance = glm::length((p[0] + p[1]) / 2.0 - view.eye);
            ASSERT_GE(distance, last - 1e-12);
            last = distance;
            ASSERT_EQ((entry & State<2>::culled_bit) == 0, in_view(view, p));
        }
    }
}

TEST(Traversal, RecordingChangesNothing) {
    Random random(12);
    for (int i = 0; i < test::soak_count(400); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        const Settings settings = test::random_settings(random);
        const CellComplex<2> cells = build_cells(scene, settings);
        const Frame<2> frame = make_frame<2>(scene.primitives, cells, make_view(test::random_view(random)), settings);
        const Method<2>& method = find_method<2>(method_table<2>(), settings.method);
        State<2> recorded, quiet;
        record_all(method, frame, recorded);
        method.start(frame, quiet);
        while (method.run(frame, quiet, 1 + static_cast<std::uint32_t>(random.below(9))) == Stop::steps) {
        }
        ASSERT_EQ(state_hash(recorded), state_hash(quiet)) << "scene " << i;
    }
}

TEST(Traversal, AnyWalkOfUndoAndRedoComesBackToTheSameHash) {
    Random random(13);
    for (int i = 0; i < test::soak_count(300); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        const Settings settings = test::random_settings(random);
        const CellComplex<2> cells = build_cells(scene, settings);
        const Frame<2> frame = make_frame<2>(scene.primitives, cells, make_view(test::random_view(random)), settings);
        const Method<2>& method = find_method<2>(method_table<2>(), settings.method);

        // Forward only: the hash after every step. A budget may end a step early and resume adds to the same step.
        std::vector<std::uint64_t> hashes;
        State<2> forward;
        method.start(frame, forward);
        hashes.push_back(state_hash(forward));
        Timeline once;
        while (method.record(frame, forward, once) == Stop::none) hashes.push_back(state_hash(forward));

        State<2> state;
        Timeline timeline;
        method.start(frame, state);
        timeline.seed_count = state.front_size;
        for (int move = 0; move < 60; ++move) {
            const auto target = static_cast<std::uint32_t>(random.below(hashes.size()));
            while (state.step > target) {
                undo_step(frame, state, timeline);
                ASSERT_EQ(state_hash(state), hashes[state.step]) << "back, scene " << i;
            }
            while (state.step < target) {
                if (state.step < timeline.steps.size())
                    redo_step(frame, state, timeline);
                else
                    ASSERT_EQ(method.record(frame, state, timeline), Stop::none);
                ASSERT_EQ(state_hash(state), hashes[state.step]) << "forward, scene " << i;
            }
            // After an undo the front is rebuilt: going on without the recording must find the same order.
            if (random.below(4) == 0) {
                State<2> branch = state;
                while (method.run(frame, branch, 5) == Stop::steps) {
                }
                ASSERT_EQ(state_hash(branch), hashes.back()) << "branch, scene " << i;
            }
        }
    }
}

TEST(Traversal, ABudgetSelectsAPrefixOfTheSameOrder) {
    Random random(14);
    for (int i = 0; i < test::soak_count(300); ++i) {
        const Scene<2> scene = test::random_scene(random, 1 + random.below(100));
        Settings settings = test::random_settings(random);
        settings.budget = {};
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        const Method<2>& method = find_method<2>(method_table<2>(), settings.method);
        State<2> whole;
        record_all(method, make_frame<2>(scene.primitives, cells, view, settings), whole);

        State<2> state;
        Timeline timeline;
        Frame<2> frame = make_frame<2>(scene.primitives, cells, view, settings);
        frame.budget = static_cast<std::uint32_t>(random.below(20));
        method.start(frame, state);
        for (;;) {
            const Stop stop = method.record(frame, state, timeline);
            ASSERT_LE(state.spent, frame.budget);
            ASSERT_TRUE(std::equal(state.touched.begin(), state.touched.end(), whole.touched.begin()));
            if (stop == Stop::front_empty) break;
            // A larger budget goes on in the same cell.
            if (stop == Stop::budget) frame.budget += 1 + static_cast<std::uint32_t>(random.below(20));
        }
        ASSERT_EQ(state.touched, whole.touched);
        ASSERT_EQ(state_hash(state), state_hash(whole)) << "scene " << i;  // nothing was done twice on the way
    }
}

TEST(Traversal, EveryPrimitiveInViewIsRenderedOnceWithoutABudget) {
    Random random(15);
    for (int i = 0; i < test::soak_count(300); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        Settings settings = test::random_settings(random);
        settings.budget = {};
        settings.border = Border::inflated;
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        State<2> state;
        record_all(find_method<2>(method_table<2>(), settings.method),
                   make_frame<2>(scene.primitives, cells, view, settings), state);
        std::vector<int> times(scene.primitives.size());
        for (const std::uint32_t entry : state.touched)
            if (!(entry & State<2>::culled_bit)) ++times[entry];
        for (std::size_t p = 0; p < times.size(); ++p)
            ASSERT_EQ(times[p], in_view(view, scene.primitives[p])) << "scene " << i << " primitive " << p;
    }
}

/// The nearest cell may lie beside a narrow view; neighbours outside the view are not followed from there.
TEST(Traversal, AnEyeOutsideStartsFromACellInItsView) {
    Random random(27);
    for (int i = 0; i < test::soak_count(200); ++i) {
        const Scene<2> scene = test::random_scene(random, 150);
        Settings settings;
        settings.tessellation = Tessellation::tree;
        settings.seeds = random.below(2) ? Seeds::one : Seeds::hull;
        const CellComplex<2> cells = build_cells(scene, settings);
        const double angle = random.uniform(0, 360);
        const Vec<2> eye = Vec<2>(0.5) + Vec<2>(sincos_degrees(angle).cos, sincos_degrees(angle).sin) * 1.5;
        const View<2> view = make_view(ViewSpec<2>{eye, {random.unit(), random.unit()}, random.uniform(3, 20)});
        const Frame<2> frame = make_frame<2>(scene.primitives, cells, view, settings);
        State<2> state;
        record_all(find_method<2>(method_table<2>(), "published"), frame, state);
        std::size_t in_sight = 0;
        for (const Primitive<2>& p : scene.primitives) in_sight += in_view(view, p);
        ASSERT_EQ(state.rendered_count, in_sight) << "scene " << i;
    }
}

TEST(Traversal, ScalingByPowersOfTwoKeepsTheOrderBitForBit) {
    Random random(16);
    for (int i = 0; i < test::soak_count(100); ++i) {
        const Scene<2> scene = test::random_scene(random, 1 + random.below(80));
        Settings settings = test::random_settings(random);
        const ViewSpec<2> view = test::random_view(random);
        std::vector<std::uint32_t> first;
        for (const double scale : {1.0, 0x1p-20, 0x1p20}) {
            Scene<2> scaled = scene;
            for (Primitive<2>& p : scaled.primitives)
                for (Vec<2>& v : p) v *= scale;
            const CellComplex<2> cells = build_cells(scaled, settings);
            State<2> state;
            const Frame<2> frame =
                make_frame<2>(scaled.primitives, cells,
                              make_view(ViewSpec<2>{view.eye * scale, view.look_at * scale, view.fov}), settings);
            const auto order =
                popped_cells(record_all(find_method<2>(method_table<2>(), settings.method), frame, state));
            if (scale == 1)
                first = order;
            else
                ASSERT_EQ(order, first) << "scene " << i << " scale " << scale;
        }
    }
}

TEST(Traversal, StartingAnotherFrameForgetsTheLast) {
    Random random(17);
    State<2> reused;
    const Scene<2> scene = test::random_scene(random, 80);
    for (int i = 0; i < test::soak_count(50); ++i) {
        Settings settings = test::random_settings(random);
        const CellComplex<2> cells = build_cells(scene, settings);
        const Method<2>& method = find_method<2>(method_table<2>(), settings.method);
        for (int view = 0; view < 4; ++view) {
            const Frame<2> frame =
                make_frame<2>(scene.primitives, cells, make_view(test::random_view(random)), settings);
            State<2> fresh;
            record_all(method, frame, fresh);
            record_all(method, frame, reused);
            ASSERT_EQ(state_hash(fresh), state_hash(reused));
        }
    }
}

/// The template in three dimensions: octree cells, triangles given to the leaves that hold their corners.
TEST(Traversal, StepsBothWaysInThreeDimensions) {
    Random random(18);
    for (int i = 0; i < test::soak_count(30); ++i) {
        const Scene<3> scene = test::random_scene_3d(random, 60);
        const Settings settings = test::random_settings(random);
        const CellComplex<3> cells = build_cells(scene, settings);
        if (cells.cell_count() == 0) continue;
        const ViewSpec<3> spec{{random.uniform(-1, 2), random.uniform(-1, 2), random.uniform(-1, 2)}, {.5, .5, .5}, 60};
        const Frame<3> frame = make_frame<3>(scene.primitives, cells, make_view(spec, 4.0 / 3), settings);
        const Method<3>& method = find_method<3>(method_table<3>(), settings.method);
        State<3> state;
        Timeline timeline = record_all(method, frame, state);
        ASSERT_GT(state.step, 0u);
        const std::uint64_t end = state_hash(state);
        State<3> start;
        method.start(frame, start);
        const std::uint32_t steps = state.step;
        while (state.step > 0) undo_step(frame, state, timeline);
        ASSERT_EQ(state_hash(state), state_hash(start));
        while (state.step < steps) redo_step(frame, state, timeline);
        ASSERT_EQ(state_hash(state), end);
    }
}

}  // namespace
}  // namespace sightline
