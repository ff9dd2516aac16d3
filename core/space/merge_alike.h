// Trees as coarse as opacity allows: what tells nothing new is not split (split_for=opacity).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/tree.h"

namespace sightline {

/// The tree without the leaves that say no more than their parent, from the bottom up: a node whose children are all
/// leaves becomes one where the opacity of each differs from its own by at most `tolerance`, in [0, 1). The opacity of
/// a part is τ / (1 + τ): τ primitives are met in the mean by a line through it, as long as the node's mean chord
/// (core/geometry/clip.h). Nodes and leaves keep their order; a joined leaf is empty where all its leaves were.
template <int D>
Tree<D> merge_alike(const Tree<D>& tree, const std::vector<Primitive<D>>& primitives, double tolerance);

extern template Tree<2> merge_alike<2>(const Tree<2>&, const std::vector<Primitive<2>>&, double);
extern template Tree<3> merge_alike<3>(const Tree<3>&, const std::vector<Primitive<3>>&, double);

}  // namespace sightline
