// The points that the Delaunay form joins to cells: one for each leaf of the tree, and the corners of the border.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cell_complex.h"

namespace sightline {

/// Leaf centres in leaf order, each moved by at most `jitter` of the leaf's side along each axis (TVCG section 4.3);
/// with empty_leaves=drop without those of empty leaves, the others being the same points; with empty_leaves=merge
/// those of a node have one together, the mean of their centres, in the place of the first. Then, with the inflated
/// border, the corners of a box around the tree's root.
template <int D>
std::vector<Vec<D>> sample_points(const Tree<D>& tree, const TessellationSettings& settings);

/// Fills leaf_cell: for each leaf the last cell that has its point as a corner; for one without a point that of the
/// nearest leaf before it that has one.
template <int D>
void set_leaf_cells(CellComplex<D>& cells, const Tree<D>& tree, const TessellationSettings& settings);

}  // namespace sightline
