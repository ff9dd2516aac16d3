// A tree of boxes in which a primitive is referred to from every leaf that it reaches.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/box_tree.h"
#include "core/space/tree.h"

namespace sightline {

/// Space itself is cut, so that the leaves do not overlap, as in the octrees and kD-trees of Coorg and Teller (sections
/// 3 and 4); `boxes` then holds what is in them: nodes with nothing in them are left out, and boxes are as tight as the
/// part of the primitives' boxes that lies in the node. A primitive may stand in several leaves.
template <int D>
struct ReferenceTree {
    Tree<D> space;
    BoxTree<D> boxes;
    std::vector<std::uint32_t> parent;   ///< of each box; none: the root
    std::vector<std::uint32_t> leaf_of;  ///< of each box, the leaf of `space`; none: an inner one
};

enum class TreeKind : std::uint8_t { kd, octree };

/// Splits a node while it holds more than `leaf` primitives (kd: their middles; octree: that many distinct corners) and
/// its side is at least `least_side` of the scene's longest one. 3D: conservative by rounding, never without one that
/// meets it.
template <int D>
ReferenceTree<D> build_reference_tree(const Scene<D>& scene, TreeKind kind, std::uint32_t leaf, double least_side);

extern template ReferenceTree<2> build_reference_tree<2>(const Scene<2>&, TreeKind, std::uint32_t, double);
extern template ReferenceTree<3> build_reference_tree<3>(const Scene<3>&, TreeKind, std::uint32_t, double);

}  // namespace sightline
