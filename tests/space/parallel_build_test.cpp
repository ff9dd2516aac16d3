// Scenes so large that trees are built and triangles assigned by several threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "core/session/settings.h"
#include "core/space/builders.h"
#include "tests/space/random_cells.h"

namespace sightline::test {
namespace {

/// Corners on a grid, so that many coincide.
std::vector<Primitive<3>> on_a_grid(Random& random, std::size_t count, double grid) {
    std::vector<Primitive<3>> triangles = random_triangles(random, count);
    for (Primitive<3>& t : triangles)
        for (Vec<3>& corner : t)
            for (int i = 0; i < 3; ++i) corner[i] = std::floor(corner[i] * grid) / grid;
    return triangles;
}

/// Which corners, of those in different places, lie in each node.
void expect_built_as_said(const Tree<3>& tree, const std::vector<Primitive<3>>& primitives, double least_side,
                          std::size_t capacity) {
    const auto less = [](const Vec<3>& a, const Vec<3>& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::set<Vec<3>, decltype(less)> corners(less);
    for (const Primitive<3>& t : primitives) corners.insert(t.begin(), t.end());
    std::vector<std::size_t> held(tree.nodes.size());
    for (const Vec<3>& corner : corners) {
        tree.walk_to_leaf(corner, [&](std::uint32_t node) { ++held[node]; });
    }
    std::vector<std::uint32_t> empty;
    for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
        const auto& at = tree.nodes[node];
        const bool splits = held[node] > capacity && at.box.extent().x >= least_side;
        ASSERT_EQ(at.first_child != none, splits) << node;
        if (held[node] == 0 && at.leaf != none) empty.push_back(at.leaf);
    }
    std::sort(empty.begin(), empty.end());
    ASSERT_EQ(tree.empty_leaves, empty);
}

TEST(ParallelBuild, ATreeSplitsWhereMoreLiesThanALeafMayHold) {
    Random random(6);
    for (const auto& [grid, bound, capacity] :
         {std::tuple{7.0, 0.03, 1u}, {40.0, 0.03, 1u}, {300.0, 0.01, 3u}, {25.0, 0.2, 40u}}) {
        const auto triangles = on_a_grid(random, 40'000, grid);
        const Tree<3> tree = build_tree<3>(triangles, bound, capacity);
        const double side = bounds<3>(triangles).longest_side();
        ASSERT_NO_FATAL_FAILURE(expect_built_as_said(tree, triangles, bound * side, capacity)) << grid;
    }
}

TEST(ParallelBuild, TrianglesAreInTheSameCellsFromAnyNumberOfThreads) {
    Random random(7);
    const auto triangles = on_a_grid(random, 30'000, 50);
    for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree}) {
        Settings settings;
        settings.tessellation = kind;
        Scene<3> scene;
        scene.primitives = triangles;
        const CellComplex<3> cells = build_cells(scene, settings);
        ASSERT_GT(cells.cell_primitives.size(), triangles.size());
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
            ASSERT_TRUE(std::is_sorted(cells.primitives_of(cell).begin(), cells.primitives_of(cell).end()));
        for (const int threads : {1, 2, 3}) {
            CellComplex<3> again = tessellation(scene, settings);
            ASSERT_EQ(again.cell_points, cells.cell_points);
            assign_primitives(again, triangles, {}, most_references, threads);
            ASSERT_EQ(again.cell_primitive_begin, cells.cell_primitive_begin);
            ASSERT_EQ(again.cell_primitives, cells.cell_primitives);
            ASSERT_EQ(again.rho_max, cells.rho_max);
            ASSERT_EQ(again.unassigned, cells.unassigned);
        }
        // A few by themselves, so that they begin in other places.
        const CellComplex<3> empty = tessellation(scene, settings);
        for (std::uint32_t first = 1; first < triangles.size(); first += 997) {
            CellComplex<3> alone = empty;
            assign_primitives(alone, {triangles[first]});
            for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
                const auto row = cells.primitives_of(cell);
                ASSERT_EQ(alone.count(cell) > 0, std::binary_search(row.begin(), row.end(), first));
            }
        }
    }
}

}  // namespace
}  // namespace sightline::test
