// The steps from a scene to a cell complex; build_cells (cell_complex.h) runs them in turn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/cell_complex.h"

namespace sightline {

/// Delaunay triangulation of the (jittered) leaf centres (TVCG section 4.3), renumbered canonically: points in leaf
/// order and then the border's corners, cells sorted by their corners. Moves the tree into the result.
CellComplex<2> delaunay_cells(Tree<2> tree, const Settings& settings);

/// The tessellation that the settings ask for, without primitives.
CellComplex<2> tessellation(const Scene<2>& scene, const Settings& settings);
CellComplex<3> tessellation(const Scene<3>& scene, const Settings& settings);

/// The leaves as cells; face neighbours of different size in both directions (TVCG fig. 9).
template <int D>
CellComplex<D> tree_cells(Tree<D> tree);
extern template CellComplex<2> tree_cells<2>(Tree<2>);
extern template CellComplex<3> tree_cells<3>(Tree<3>);

/// Fills the rows cell -> primitives, by exact predicates on closed cells, and unassigned.
void assign_primitives(CellComplex<2>& cells, const std::vector<Primitive<2>>& primitives);
void assign_primitives(CellComplex<3>& cells, const std::vector<Primitive<3>>& primitives);

/// Compresses (cell, primitive) pairs into rows sorted by primitive, and fills rho_max and rho_p95.
template <int D>
void set_cell_primitives(CellComplex<D>& cells, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);

}  // namespace sightline
