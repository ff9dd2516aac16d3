// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <utility>

#include "core/base/trig.h"
#include "core/methods/cells/facet_geometry.h"
#include "core/methods/cells/seed_cells.h"
#include "core/methods/plp/plp_parameters.h"
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

/// The gem's step(): a cell is rendered whole, counts all that it holds while it is in view, and ends the run when the
/// budget is reached.
template <int D>
void expect_whole_cells(const Scene<D>& scene, const CellComplex<D>& cells, const View<D>& view, Settings settings) {
    apply_setting(settings, "budget_counts=per_cell");
    const Problem<D> problem = problem_of(scene, cells, view, settings);
    Problem<D> unlimited = problem;
    unlimited.budget = none;
    for (const char* id : {"published", "layers"}) {
        const Method<D>& method = find_method<D>(method_table<D>(), id);
        const Recorded<D> recorded = record_all(method, problem);
        std::vector<std::uint32_t> order = popped_cells(record_all(method, unlimited).timeline), rendered;
        std::vector<std::uint8_t> met(scene.primitives.size());
        std::uint32_t spent = 0;
        std::size_t steps = 0;
        while (steps < order.size() && spent < problem.budget) {
            const std::uint32_t cell = order[steps++];
            for (const std::uint32_t primitive : cells.primitives_of(cell))
                if (!std::exchange(met[primitive], std::uint8_t{1}) && shows(problem, primitive))
                    rendered.push_back(primitive);
            if (cell_in_view(cells, view, cell)) spent += cells.count(cell);
        }
        order.resize(steps);
        ASSERT_EQ(popped_cells(recorded.timeline), order) << id;
        ASSERT_EQ(rendered_ids(recorded.run->met()), rendered) << id;
        ASSERT_EQ(recorded.run->counters().spent, spent) << id;
    }
}

TEST(Traversal, ABudgetOfWholeCellsCountsAsTheGemDoes) {
    Random random(12);
    for (int i = 0; i < test::soak_count(100); ++i) {
        Settings settings = test::random_wide_settings(random);
        settings.budget = {Budget::Kind::primitives, static_cast<double>(random.below(200))};
        const Scene<2> scene = test::random_scene(random, 5 + random.below(100));
        expect_whole_cells<2>(scene, build_cells(scene, settings), make_view(test::random_view(random)), settings);
        if (i % 4 != 0) continue;
        settings.error_bound = 0.3;
        const Scene<3> solid = test::random_scene_3d(random, 60);
        const Vec<3> eye(random.uniform(-1, 2), random.uniform(-1, 2), random.uniform(-1, 2));
        expect_whole_cells<3>(solid, build_cells(solid, settings),
                              make_view(ViewSpec<3>{eye, {.5, .5, .5}, 60}, 4.0 / 3), settings);
    }
}

/// Every key of `published` is worked out again from what its step recorded.
template <int D>
void expect_own_content(const Scene<D>& scene, const CellComplex<D>& cells, const View<D>& view, Settings settings) {
    apply_setting(settings, "own_content=on");
    const Problem<D> problem = problem_of(scene, cells, view, settings);
    const Recorded<D> recorded = record_all(find_method<D>(method_table<D>(), "published"), problem);
    const double scale = solidity_scale(problem);
    const PlpParameters parameters(problem.parameters);
    for (std::uint32_t step = 1; step <= recorded.timeline.size(); ++step) {
        const Step& popped = recorded.timeline.steps[step - 1];
        for (const Considered& c : recorded.run->considered(popped, recorded.timeline.changes_of(step), 3)) {
            if (!c.key) continue;
            const auto facets = cells.facets_of(popped.item.id);
            const HalfFacet half =
                *std::find_if(facets.begin(), facets.end(), [&](const HalfFacet& h) { return h.facet() == c.via.id; });
            const FacetGeometry<D> facet = facet_geometry(cells, half);
            double angle = cosine<D>(
                parameters.view_vector == ViewVector::eye ? facet.centroid - view.eye : view.forward(), facet.normal);
            if (parameters.transfer_sign == TransferSign::clamp) angle = std::max(angle, 0.0);
            if (parameters.transfer_sign == TransferSign::abs) angle = std::abs(angle);
            double key = std::min(cells.count(popped.item.id) / scale, 1.0) + angle * popped.key +
                         std::min(cells.count(half.neighbour) / scale, 1.0);
            if (c.key->penalised)
                key = parameters.penalty == Penalty::multiply ? key * parameters.penalty_amount
                                                              : key + parameters.penalty_amount;
            ASSERT_DOUBLE_EQ(c.key->key, key);
        }
    }
}

TEST(Traversal, WithOwnContentACellsPrimitivesCountForItself) {
    Random random(14);
    for (int i = 0; i < test::soak_count(60); ++i) {
        Settings settings = test::random_wide_settings(random);
        const Scene<2> scene = test::random_scene(random, 5 + random.below(100));
        expect_own_content<2>(scene, build_cells(scene, settings), make_view(test::random_view(random)), settings);
        if (i % 4 != 0) continue;
        settings.error_bound = 0.3;
        const Scene<3> solid = test::random_scene_3d(random, 60);
        expect_own_content<3>(solid, build_cells(solid, settings),
                              make_view(ViewSpec<3>{{-.5, .2, .3}, {.5, .5, .5}, 60}, 4.0 / 3), settings);
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
