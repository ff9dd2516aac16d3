// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/trig.h"
#include "core/methods/cells/seed_cells.h"
#include "core/session/settings_table.h"
#include "core/space/builders.h"
#include "core/space/cell_in_view.h"
#include "tests/run/reference_traversal.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using test::popped_cells, test::problem_of, test::record_all, test::Recorded;

TEST(Traversal, OrderIsThatOfThePapersStructure) {
    Random random(11);
    for (int i = 0; i < test::soak_count(400); ++i) {
        const Scene<2> scene = test::random_scene(random, 5 + random.below(120));
        Settings settings;
        settings.tessellation = static_cast<Tessellation>(random.below(tessellation_count));
        if (random.below(2)) settings.neighbours = Neighbours::touching;
        settings.jitter = random.below(2) ? 0.02 : 0;
        if (random.below(2)) settings.budget = {Budget::Kind::primitives, static_cast<double>(random.below(100))};
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        const Problem<2> problem = problem_of(scene, cells, view, settings);
        const Recorded<2> recorded = record_all(find_method<2>(method_table<2>(), "published"), problem);

        std::vector<std::uint32_t> projected, rendered;
        if (problem.budget > 0)
            test::PaperTraversal(scene, cells)
                .run(view, seed_cells(problem).front(), problem.budget, projected, rendered);
        ASSERT_EQ(popped_cells(recorded.timeline), projected) << "scene " << i;
        ASSERT_EQ(rendered_ids(recorded.run->met()), rendered) << "scene " << i;
    }
}

/// The gem's layers are the rings of a breadth-first search over cells in view.
TEST(Traversal, LayersPopCellsBreadthFirst) {
    Random random(19);
    for (int i = 0; i < test::soak_count(200); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        Settings settings = test::random_settings(random);
        apply_setting(settings, "outside_view=unseen");
        settings.budget = {};
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        const Problem<2> problem = problem_of(scene, cells, view, settings);
        const Recorded<2> recorded = record_all(find_method<2>(method_table<2>(), "layers"), problem);

        std::vector<std::uint32_t> queue = seed_cells(problem);
        std::vector<std::uint8_t> seen(cells.cell_count());
        for (const std::uint32_t seed : queue) seen[seed] = 1;
        for (std::size_t next = 0; next < queue.size(); ++next)
            for (const HalfFacet& half : cells.facets_of(queue[next])) {
                if (half.neighbour == none || seen[half.neighbour]) continue;
                seen[half.neighbour] = 1;
                if (cell_in_view(cells, view, half.neighbour)) queue.push_back(half.neighbour);
            }
        ASSERT_EQ(popped_cells(recorded.timeline), queue) << "scene " << i;
    }
}

TEST(Traversal, CentroidOrderIsByDistanceAndCullsTheView) {
    Random random(20);
    for (int i = 0; i < test::soak_count(100); ++i) {
        const Scene<2> scene = test::random_scene(random, random.below(100));
        const Settings settings;
        const CellComplex<2> cells = build_cells(scene, settings);
        const View<2> view = make_view(test::random_view(random));
        const Recorded<2> recorded =
            record_all(find_method<2>(method_table<2>(), "centroid"), problem_of(scene, cells, view, settings));
        ASSERT_EQ(recorded.run->met().size(), scene.primitives.size());
        double last = 0;
        for (const Met entry : recorded.run->met()) {
            const Primitive<2>& p = scene.primitives[entry.primitive()];
            const double distance = glm::length((p[0] + p[1]) / 2.0 - view.eye);
            ASSERT_GE(distance, last - 1e-12);
            last = distance;
            ASSERT_EQ(!entry.culled(), in_view(view, p));
        }
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
        const Recorded<2> recorded =
            record_all(find_method<2>(method_table<2>(), settings.method), problem_of(scene, cells, view, settings));
        std::vector<int> times(scene.primitives.size());
        for (const std::uint32_t primitive : rendered_ids(recorded.run->met())) ++times[primitive];
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
        apply_setting(settings, random.below(2) ? "seeds=one" : "seeds=hull");
        const CellComplex<2> cells = build_cells(scene, settings);
        const double angle = random.uniform(0, 360);
        const Vec<2> eye = Vec<2>(0.5) + Vec<2>(sincos_degrees(angle).cos, sincos_degrees(angle).sin) * 1.5;
        const View<2> view = make_view(ViewSpec<2>{eye, {random.unit(), random.unit()}, random.uniform(3, 20)});
        const Problem<2> problem = problem_of(scene, cells, view, settings);
        const Recorded<2> recorded = record_all(find_method<2>(method_table<2>(), "published"), problem);
        std::size_t in_sight = 0;
        for (const Primitive<2>& p : scene.primitives) in_sight += in_view(view, p);
        ASSERT_EQ(recorded.run->counters().rendered_count, in_sight) << "scene " << i;
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
            const View<2> scaled_view = make_view(ViewSpec<2>{view.eye * scale, view.look_at * scale, view.fov});
            const auto order = popped_cells(record_all(find_method<2>(method_table<2>(), settings.method),
                                                       problem_of(scaled, cells, scaled_view, settings))
                                                .timeline);
            if (scale == 1)
                first = order;
            else
                ASSERT_EQ(order, first) << "scene " << i << " scale " << scale;
        }
    }
}

}  // namespace
}  // namespace sightline
