// Trees with references: everything is found where it lies, and nothing is where it does not.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/reference_tree.h"

#include <gtest/gtest.h>

#include "tests/scene/random_scene.h"

namespace sightline {
namespace {

Scene<2> scene_of(Random& random, std::size_t count, Scene<2>) { return test::random_scene(random, count); }
Scene<3> scene_of(Random& random, std::size_t count, Scene<3>) { return test::random_scene_3d(random, count); }

template <int D>
void check_tree(const Scene<D>& scene, const ReferenceTree<D>& tree, Random& random) {
    const auto& nodes = tree.boxes.nodes;
    ASSERT_EQ(nodes.empty(), scene.primitives.empty());
    std::vector<std::uint8_t> held(scene.primitives.size());
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        const auto& here = nodes[node];
        ASSERT_LT(here.begin, here.end) << "no node is empty";
        if (here.first_child == none) {
            ASSERT_NE(tree.leaf_of[node], none);
            for (const std::uint32_t primitive : tree.boxes.primitives_of(node)) held[primitive] = 1;
            continue;
        }
        ASSERT_GT(here.child_count, 1u);
        std::uint32_t at = here.begin;
        for (std::uint32_t child = here.first_child; child < here.first_child + here.child_count; ++child) {
            ASSERT_EQ(tree.parent[child], node);
            ASSERT_EQ(nodes[child].begin, at);
            at = nodes[child].end;
            for (int i = 0; i < D; ++i) {
                ASSERT_GE(nodes[child].box.min[i], here.box.min[i]);
                ASSERT_LE(nodes[child].box.max[i], here.box.max[i]);
            }
        }
        ASSERT_EQ(at, here.end);
    }
    for (const std::uint8_t is_held : held) ASSERT_TRUE(is_held);
    // Any point of a primitive lies in a leaf's box that refers to it.
    for (std::uint32_t primitive = 0; primitive < scene.primitives.size(); ++primitive)
        for (int k = 0; k < 5; ++k) {
            Vec<D> p(0);
            double left = 1;
            for (int corner = 0; corner < D; ++corner) {
                const double share = corner == D - 1 ? left : left * random.unit();
                left -= share;
                p += scene.primitives[primitive][static_cast<std::size_t>(corner)] * share;
            }
            bool found = false;
            for (std::uint32_t node = 0; node < nodes.size() && !found; ++node) {
                if (nodes[node].first_child != none) continue;
                bool inside = true;  // but for the rounding of p
                for (int i = 0; i < D; ++i)
                    inside &= p[i] >= nodes[node].box.min[i] - 1e-12 && p[i] <= nodes[node].box.max[i] + 1e-12;
                const auto in_leaf = tree.boxes.primitives_of(node);
                found = inside && std::find(in_leaf.begin(), in_leaf.end(), primitive) != in_leaf.end();
            }
            ASSERT_TRUE(found) << primitive;
        }
}

template <int D>
void trees_hold_all(std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < 40; ++i) {
        const Scene<D> scene = scene_of(random, random.below(60), Scene<D>{});
        for (const TreeKind kind : {TreeKind::kd, TreeKind::octree})
            for (const std::uint32_t leaf : {1u, 8u}) {
                const ReferenceTree<D> tree = build_reference_tree(scene, kind, leaf, 1.0 / 64);
                check_tree(scene, tree, random);
                if (testing::Test::HasFatalFailure()) return;
            }
    }
}
TEST(ReferenceTree, HoldsAll2d) { trees_hold_all<2>(81); }
TEST(ReferenceTree, HoldsAll3d) { trees_hold_all<3>(82); }

}  // namespace
}  // namespace sightline
