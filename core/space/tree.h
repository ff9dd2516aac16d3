// Occupancy tree over the vertices of a scene: a quadtree in 2D, an octree in 3D (TVCG section 4.3).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/index.h"
#include "core/scene/scene.h"

namespace sightline {

/// Nodes in a flat array, root first, the 2^D children of a node side by side. Interior nodes are kept. Child c of a
/// node covers the upper half of axis i when bit i of c is set.
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

    const Box<D>& root_box() const { return nodes.front().box; }

    /// The leaf that contains p; p outside the root counts as its nearest point inside. On a shared border: the upper.
    std::uint32_t leaf_at(const Vec<D>& p) const {
        std::uint32_t node = 0;
        while (nodes[node].first_child != none) {
            const Vec<D> middle = nodes[nodes[node].first_child].box.max;
            std::uint32_t child = 0;
            for (int i = 0; i < D; ++i) child |= static_cast<std::uint32_t>(p[i] >= middle[i]) << i;
            node = nodes[node].first_child + child;
        }
        return nodes[node].leaf;
    }
};

/// Splits a node while it holds more than one distinct vertex and its side is at least `error_bound` times the longest
/// side of the scene's box. The root is the cube around the box (the unit cube at the origin when the scene has no
/// extent). `error_bound` in (0, 1].
template <int D>
Tree<D> build_tree(const std::vector<Primitive<D>>& primitives, double error_bound);

extern template Tree<2> build_tree<2>(const std::vector<Primitive<2>>&, double);
extern template Tree<3> build_tree<3>(const std::vector<Primitive<3>>&, double);

}  // namespace sightline
