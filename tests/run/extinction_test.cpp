// Extinction: what lies in a cell, how far a ray goes in it, and keys that are shortest ways.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/extinction/extinction.h"

#include <gtest/gtest.h>

#include <map>

#include "core/scene/scene_view.h"
#include "core/space/builders.h"
#include "tests/run/run_support.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

Scene<2> random_soup(Random& random, Vec<2>) { return test::random_scene(random, 5 + random.below(60)); }
Scene<3> random_soup(Random& random, Vec<3>) { return test::random_scene_3d(random, 5 + random.below(40)); }

double size_of(const Primitive<2>& p) { return glm::length(p[1] - p[0]); }
double size_of(const Primitive<3>& p) { return glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2; }

/// Cells tile space, so that the parts of a primitive, and of a line, make up the whole.
template <int D>
void expect_parts_make_up_the_whole() {
    Random random(70 + D);
    for (int round = 0; round < test::soak_count(20); ++round)
        for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree, Tessellation::kd}) {
            const Scene<D> scene = random_soup(random, Vec<D>(0));
            Settings settings;
            settings.tessellation = kind;
            settings.error_bound = 0.3;
            settings.leaf_capacity = 3;
            const CellComplex<D> cells = build_cells(scene, settings);
            // Not on a plane between cells, where a part would count twice.
            Primitive<D> primitive;
            const Box<D> box = cells.tree.root_box();
            for (Vec<D>& corner : primitive)
                for (int i = 0; i < D; ++i) corner[i] = random.uniform(box.min[i], box.max[i]);
            double size = 0, way = 0;
            for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
                size += size_in_cell<D>(cells, cell, primitive);
                way += length_in_cell(cells, cell, primitive[0], primitive[1]);
            }
            const double length = glm::length(primitive[1] - primitive[0]);
            EXPECT_NEAR(size, size_of(primitive), 1e-9 * (1 + size)) << word(kind) << ' ' << round;
            EXPECT_NEAR(way, length, 1e-9 * (1 + length)) << word(kind) << ' ' << round;
        }
}
TEST(Extinction, PartsInCellsMakeUpTheWhole2d) { expect_parts_make_up_the_whole<2>(); }
TEST(Extinction, PartsInCellsMakeUpTheWhole3d) { expect_parts_make_up_the_whole<3>(); }

TEST(Extinction, OfAWallAcrossACube) {
    Scene<3> scene;  // through the middle of the unit cube, and its far corners so that the cube is the root
    scene.primitives = {{Vec<3>(.5, 0, 0), Vec<3>(.5, 1, 0), Vec<3>(.5, 1, 1)},
                        {Vec<3>(.5, 0, 0), Vec<3>(.5, 1, 1), Vec<3>(.5, 0, 1)}};
    Settings settings;
    settings.tessellation = Tessellation::tree;
    settings.error_bound = 1;
    settings.leaf_capacity = 10;
    const CellComplex<3> cells = build_cells(scene, settings);
    ASSERT_EQ(cells.cell_count(), 1u);
    Problem<3> problem;
    problem.scene = &scene;
    problem.cells = &cells;
    const auto made = cell_extinction(problem);
    EXPECT_NEAR(made->depth[0], 2.0 / 6, 1e-12);
    EXPECT_NEAR(made->chord[0], 4.0 / 6, 1e-12);
    EXPECT_EQ(made, cell_extinction(problem)) << "made once";
}

/// Since no way gets shorter by what it crosses, cells are popped by the shortest way from the seed.
template <int D>
void expect_shortest_ways(std::uint64_t seed) {
    Random random(seed);
    std::size_t above_0 = 0;
    for (int round = 0; round < test::soak_count(10); ++round) {
        const Scene<D> scene = random_soup(random, Vec<D>(0));
        Settings settings;
        settings.tessellation = static_cast<Tessellation>(round % 3);
        settings.method = "extinction";
        apply_setting(settings, "outside_view=enqueue");
        const CellComplex<D> cells = build_cells(scene, settings);
        ViewSpec<D> spec;
        for (int i = 0; i < D; ++i) spec.eye[i] = random.uniform(0, 1);
        spec.look_at = spec.eye + Vec<D>(1);
        const View<D> view = scene_view(spec, scene, settings.reference_size);
        const Method<D>& method = find_method<D>(method_table<D>(), "extinction");
        const Problem<D> problem = test::problem_of(scene, cells, view, settings);
        const auto run = method.start(problem);
        const std::uint32_t seed_cell = run->seeds().front().id;
        run->run(none);
        const Extinction<D> heuristic(problem);
        // Bellman and Ford: over all facets until nothing gets shorter.
        std::vector<double> way(cells.cell_count(), std::numeric_limits<double>::infinity());
        way[seed_cell] = 0;
        for (bool changed = true; changed;) {
            changed = false;
            for (std::uint32_t a = 0; a < cells.cell_count(); ++a)
                for (const HalfFacet& half : cells.facets_of(a)) {
                    if (half.neighbour == none || way[a] == std::numeric_limits<double>::infinity()) continue;
                    const double key = heuristic.key(problem, a, way[a], half).value;
                    if (key < way[half.neighbour]) {
                        way[half.neighbour] = key;
                        changed = true;
                    }
                }
        }
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
            ASSERT_EQ(run->mark(cell).key, way[cell]) << "cell " << cell << " in round " << round;
            above_0 += way[cell] > 0;
        }
    }
    EXPECT_GT(above_0, 100u);
}
TEST(Extinction, KeysAreShortestWays2d) { expect_shortest_ways<2>(77); }
TEST(Extinction, KeysAreShortestWays3d) { expect_shortest_ways<3>(78); }

}  // namespace
}  // namespace sightline
