// A tree of boxes over a scene: a quadtree or octree over its vertices (TVCG section 4.3), or a kd-tree.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/index.h"
#include "core/scene/scene.h"

namespace sightline {

/// Nodes in a flat array, root first, the children of a node side by side. Interior nodes are kept. A quadtree or
/// octree splits a node across all axes, in the middle: child c covers the upper half of axis i when bit i of c is set.
/// A kd-tree splits it across one, anywhere: child 1 is the upper part.
template <int D>
struct Tree {
    static constexpr int child_count = 1 << D;
    struct Node {
        Box<D> box;
        std::uint32_t first_child = none;  ///< none: a leaf
        std::uint32_t leaf = none;         ///< index among the leaves; none: an interior node
    };
    std::vector<Node> nodes;
    std::vector<std::uint32_t> leaves;  ///< leaf index -> node, in depth-first order
    /// Leaves without a vertex, ascending. Only build_tree(), and merge_alike() of what that built, say it; a cell complex does not keep it.
    std::vector<std::uint32_t> empty_leaves;

    const Box<D>& root_box() const { return nodes.front().box; }

    /// Whether the inner node is split across the axis.
    bool splits(std::uint32_t node, int axis) const {
        return nodes[nodes[node].first_child].box.max[axis] < nodes[node].box.max[axis];
    }

    /// The leaf that contains p; p outside the root counts as its nearest point inside. On a shared border: the upper.
    std::uint32_t leaf_at(const Vec<D>& p) const {
        return walk_to_leaf(p, [](std::uint32_t) {});
    }
    /// The same; calls `each` with the nodes on the way, the root first.
    template <typename Each>
    std::uint32_t walk_to_leaf(const Vec<D>& p, Each each) const {
        std::uint32_t node = 0;
        each(node);
        while (nodes[node].first_child != none) {
            const Vec<D> middle = nodes[nodes[node].first_child].box.max;
            std::uint32_t child = 0, bit = 0;
            for (int i = 0; i < D; ++i)
                if (splits(node, i)) child |= static_cast<std::uint32_t>(p[i] >= middle[i]) << bit++;
            node = nodes[node].first_child + child;
            each(node);
        }
        return nodes[node].leaf;
    }
};

/// Splits a node while it holds more than `leaf_capacity` distinct vertices and its side is at least `error_bound`
/// times the longest side of the scene's box. The root is the cube around the box (the unit cube at the origin when the
/// scene has no extent). `error_bound` in (0, 1].
template <int D>
Tree<D> build_tree(const std::vector<Primitive<D>>& primitives, double error_bound, std::uint32_t leaf_capacity = 1);

/// Splits a node across its longest side, the first of equal ones, while it holds more than `leaf_capacity` middles of
/// primitives and that side is at least `error_bound` times the longest side of the scene's box: at the median of the
/// middles, or in half where they do not tell two sides apart. The papers name kd-trees and no rule (TVCG 3.1); the
/// median gives small cells where there is much. The root is the scene's box, a side shorter than a leaf's made as long
/// as one.
template <int D>
Tree<D> build_kd_tree(const std::vector<Primitive<D>>& primitives, double error_bound, std::uint32_t leaf_capacity = 1);

extern template Tree<2> build_tree<2>(const std::vector<Primitive<2>>&, double, std::uint32_t);
extern template Tree<3> build_tree<3>(const std::vector<Primitive<3>>&, double, std::uint32_t);
extern template Tree<2> build_kd_tree<2>(const std::vector<Primitive<2>>&, double, std::uint32_t);
extern template Tree<3> build_kd_tree<3>(const std::vector<Primitive<3>>&, double, std::uint32_t);

}  // namespace sightline
