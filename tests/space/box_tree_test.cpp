// The tree of boxes: what every walk over it may count on.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "core/base/random.h"

namespace sightline::test {
namespace {

template <int D>
std::vector<Primitive<D>> scattered(std::uint64_t seed, std::size_t count, double apart) {
    Random random(seed);
    std::vector<Primitive<D>> primitives;
    for (std::size_t i = 0; i < count; ++i) {
        Vec<D> middle;
        // Spread over many sizes, so that the tree has to be uneven.
        for (int k = 0; k < D; ++k) middle[k] = apart * std::ldexp(random.unit(), -static_cast<int>(random.below(20)));
        Primitive<D> primitive;
        for (Vec<D>& corner : primitive)
            for (int k = 0; k < D; ++k) corner[k] = middle[k] + random.uniform(-0.01, 0.01);
        primitives.push_back(primitive);
    }
    return primitives;
}

template <int D>
void expect_box_tree(const BoxTree<D>& tree, const std::vector<Primitive<D>>& primitives, std::uint32_t leaf) {
    std::vector<std::uint32_t> sorted = tree.primitives;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted.size(), primitives.size());
    for (std::uint32_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
    ASSERT_FALSE(tree.nodes.empty());
    EXPECT_EQ(tree.primitives_of(0).size(), primitives.size());
    for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
        const auto& at = tree.nodes[node];
        Box<D> box;
        for (const std::uint32_t primitive : tree.primitives_of(node))
            for (const Vec<D>& corner : primitives[primitive]) box.add(corner);
        EXPECT_TRUE(box.min == at.box.min && box.max == at.box.max) << node;
        EXPECT_EQ(at.first_child == none, at.end - at.begin <= leaf) << node;
        if (at.first_child == none) {
            EXPECT_GT(at.end, at.begin);
            EXPECT_TRUE(std::is_sorted(tree.primitives.begin() + at.begin, tree.primitives.begin() + at.end));
            continue;
        }
        EXPECT_GT(at.first_child, node);
        const auto &low = tree.nodes[at.first_child], &high = tree.nodes[at.first_child + 1];
        EXPECT_TRUE(low.begin == at.begin && low.end == high.begin && high.end == at.end) << node;
    }
}

template <int D>
void check_trees() {
    for (const std::uint32_t leaf : {1u, 5u, 24u})
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const auto primitives = scattered<D>(seed, seed * 67, seed % 2 ? 1 : 0);
            expect_box_tree<D>(build_box_tree<D>(primitives, leaf), primitives, leaf);
        }
    const std::vector<Primitive<D>> same(100, scattered<D>(1, 1, 1)[0]);
    expect_box_tree<D>(build_box_tree<D>(same, 3), same, 3);
    EXPECT_TRUE(build_box_tree<D>({}).nodes.empty());
}

TEST(BoxTree, EveryPrimitiveStandsInOneLeafAndBoxesAreTight) {
    check_trees<2>();
    check_trees<3>();
}

TEST(BoxTree, CoordinatesOfAnySizeMakeATree) {
    auto primitives = scattered<3>(4, 300, 1);
    for (auto& triangle : primitives)
        for (auto& corner : triangle) corner *= 1e154;  // areas overflow
    expect_box_tree<3>(build_box_tree<3>(primitives, 4), primitives, 4);
    for (auto& triangle : primitives)
        for (auto& corner : triangle) corner *= 1e-300;
    expect_box_tree<3>(build_box_tree<3>(primitives, 4), primitives, 4);
}

TEST(BoxTree, IsBuiltOnceForAScene) {
    Scene<3> scene;
    scene.primitives = scattered<3>(2, 500, 1);
    const SceneBoxes<3> boxes;
    std::array<const BoxTree<3>*, 4> seen{};
    {
        std::vector<std::jthread> threads;
        for (auto& tree : seen) threads.emplace_back([&] { tree = &boxes.of(scene); });
    }
    for (const auto* tree : seen) EXPECT_EQ(tree, &boxes.of(scene));
    expect_box_tree<3>(boxes.of(scene), scene.primitives, box_tree_leaf);
}

}  // namespace
}  // namespace sightline::test
