// Trees as coarse as opacity allows, against opacities measured by sampling.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/merge_alike.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/space/builders.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// Length of the segment in the box, from points at equal distances along it.
double sampled_length(const Primitive<2>& segment, const Box<2>& box) {
    constexpr int samples = 4000;
    int inside = 0;
    for (int i = 0; i < samples; ++i)
        inside += box.contains(segment[0] + (segment[1] - segment[0]) * ((i + 0.5) / samples));
    return glm::length(segment[1] - segment[0]) * inside / samples;
}

/// Of a square part over a way, by the words of docs/algorithm.md: lines through the node have the mean length π/4 of
/// its side, and a line meets 2/π of what a unit of area holds per unit of its way.
double opacity_of(const std::vector<Primitive<2>>& scene, const Box<2>& part, double node_side) {
    double held = 0;
    for (const Primitive<2>& segment : scene) held += sampled_length(segment, part);
    const double met = held / (part.extent().x * part.extent().y) * node_side / 2;
    return met / (1 + met);
}

TEST(MergeAlike, JoinsLeavesAsOpaqueAsTheirNodeAndNoOthers) {
    Random random(41);
    std::size_t joined = 0, kept = 0;
    for (int round = 0; round < test::soak_count(40); ++round) {
        const std::vector<Primitive<2>> scene = test::random_scene(random, 3 + random.below(12)).primitives;
        const double tolerance = random.uniform(0.05, 0.4), unsure = 0.01;
        const Tree<2> fine = build_tree<2>(scene, 0.1, 2), coarse = merge_alike<2>(fine, scene, tolerance);
        const auto same_box = [](const Box<2>& a, const Box<2>& b) { return a.min == b.min && a.max == b.max; };
        // Each node of the coarse tree is one of the fine tree, and its leaves tile it.
        double area = 0;
        for (std::size_t leaf = 0; leaf < coarse.leaves.size(); ++leaf) {
            const auto& node = coarse.nodes[coarse.leaves[leaf]];
            ASSERT_EQ(node.leaf, leaf);
            area += node.box.extent().x * node.box.extent().y;
        }
        const Vec<2> root = fine.root_box().extent();
        EXPECT_NEAR(area, root.x * root.y, 1e-12);
        for (const auto& node : fine.nodes) {
            if (node.first_child == none) continue;
            const auto at = std::find_if(coarse.nodes.begin(), coarse.nodes.end(),
                                         [&](const auto& other) { return same_box(other.box, node.box); });
            if (at == coarse.nodes.end()) continue;  // inside a joined one
            double largest = 0;
            bool leaves = true;  // of the coarse tree, if the node were split there
            const double own = opacity_of(scene, node.box, node.box.extent().x);
            for (std::uint32_t c = 0; c < 4; ++c) {
                const auto& child = fine.nodes[node.first_child + c];
                largest = std::max(largest, std::abs(opacity_of(scene, child.box, node.box.extent().x) - own));
                const auto in_coarse = std::find_if(coarse.nodes.begin(), coarse.nodes.end(),
                                                    [&](const auto& o) { return same_box(o.box, child.box); });
                leaves = leaves && (in_coarse == coarse.nodes.end() || in_coarse->first_child == none);
            }
            if (at->first_child == none) {
                ++joined;
                EXPECT_LE(largest, tolerance + unsure);
            } else {
                ++kept;
                EXPECT_TRUE(!leaves || largest > tolerance - unsure);
            }
        }
        // Emptiness is that of the vertices, as in the fine tree.
        for (std::uint32_t leaf = 0; leaf < coarse.leaves.size(); ++leaf) {
            bool holds = false;
            for (const auto& segment : scene)
                for (const Vec<2>& p : segment) holds |= coarse.leaf_at(p) == leaf;
            EXPECT_EQ(std::binary_search(coarse.empty_leaves.begin(), coarse.empty_leaves.end(), leaf), !holds);
        }
    }
    EXPECT_GT(joined, 20u);
    EXPECT_GT(kept, 20u);
}

template <int D>
void expect_fewer_cells(const Scene<D>& scene) {
    for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree, Tessellation::kd}) {
        TessellationSettings settings;
        settings.tessellation = kind;
        const CellComplex<D> vertices = build_cells(scene, settings);
        settings.split_for = SplitFor::opacity;
        settings.opacity_tolerance = 0;
        const CellComplex<D> strict = build_cells(scene, settings);
        settings.opacity_tolerance = 0.3;
        const CellComplex<D> loose = build_cells(scene, settings);
        EXPECT_LE(strict.cell_count(), vertices.cell_count()) << word(kind);
        EXPECT_LT(loose.cell_count(), vertices.cell_count()) << word(kind);
        EXPECT_EQ(loose.unassigned, vertices.unassigned) << word(kind);
        settings.opacity_tolerance = 0.999;
        EXPECT_LE(build_cells(scene, settings).cell_count(), kind == Tessellation::delaunay ? 24u : 1u) << word(kind);
    }
}

TEST(MergeAlike, MakesFewerCellsOfEachKind) {
    Random random(42);
    expect_fewer_cells<2>(test::random_scene(random, 60));
    expect_fewer_cells<3>(test::random_scene_3d(random, 60));
}

TEST(MergeAlike, EmptyLeavesOfANodeShareACentre) {
    Random random(43);
    std::size_t merged = 0;
    for (int round = 0; round < test::soak_count(20); ++round) {
        const Scene<2> scene = test::random_scene(random, 1 + random.below(40));
        TessellationSettings settings;
        settings.jitter = 0;
        settings.border = Border::none;
        settings.empty_leaves = EmptyLeaves::merge;
        const Tree<2> tree = build_tree<2>(scene.primitives, settings.error_bound);
        std::multiset<std::pair<double, double>> expected;
        const auto is_empty = [&](std::uint32_t leaf) {
            return std::binary_search(tree.empty_leaves.begin(), tree.empty_leaves.end(), leaf);
        };
        for (const auto& node : tree.nodes) {
            if (node.leaf != none && !is_empty(node.leaf)) expected.insert({node.box.centre().x, node.box.centre().y});
            if (node.first_child == none) continue;
            Vec<2> sum(0);
            double count = 0;
            for (std::uint32_t child = node.first_child; child < node.first_child + 4; ++child)
                if (tree.nodes[child].leaf != none && is_empty(tree.nodes[child].leaf)) {
                    sum += tree.nodes[child].box.centre();
                    ++count;
                }
            if (count > 0) expected.insert({sum.x / count, sum.y / count});
            merged += count > 1;
        }
        const CellComplex<2> cells = build_cells(scene, settings);
        std::multiset<std::pair<double, double>> found;
        for (const Vec<2>& p : cells.points) found.insert({p.x, p.y});
        if (cells.cell_count() > 0) {
            EXPECT_EQ(found, expected);
        }
        EXPECT_EQ(cells.leaf_cell.size(), tree.leaves.size());
    }
    EXPECT_GT(merged, 20u);
}

}  // namespace
}  // namespace sightline
