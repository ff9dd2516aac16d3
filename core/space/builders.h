// The steps from a scene to a cell complex; build_cells (cell_complex.h) runs them in turn.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/space/cell_complex.h"

namespace sightline {

/// Delaunay triangulation of the (jittered) leaf centres (TVCG section 4.3), renumbered canonically: points in leaf
/// order and then the border's corners, cells sorted by their corners. Moves the tree into the result.
CellComplex<2> delaunay_cells(Tree<2> tree, const TessellationSettings& settings);
CellComplex<3> delaunay_cells(Tree<3> tree, const TessellationSettings& settings);

/// The tessellation that the settings ask for, without primitives.
template <int D>
CellComplex<D> tessellation(const Scene<D>& scene, const TessellationSettings& settings);

/// The leaves of a quadtree or octree as cells; face neighbours of different size in both directions (TVCG fig. 9).
/// touching: those that share an edge or a corner too, behind facets without an area (CellComplex::is_contact).
template <int D>
CellComplex<D> tree_cells(Tree<D> tree, Neighbours neighbours = Neighbours::facet);
/// The same of a kd-tree.
template <int D>
CellComplex<D> kd_cells(Tree<D> tree, Neighbours neighbours = Neighbours::facet);
extern template CellComplex<2> tree_cells<2>(Tree<2>, Neighbours);
extern template CellComplex<3> tree_cells<3>(Tree<3>, Neighbours);
extern template CellComplex<2> kd_cells<2>(Tree<2>, Neighbours);
extern template CellComplex<3> kd_cells<3>(Tree<3>, Neighbours);

/// References from cells to triangles; they take 12 bytes each while they are made, 4 when they are there, and 32 more
/// when they are traversed (cell_triangles.h).
inline constexpr std::size_t most_references = std::size_t{1} << 29;

/// Fills the rows cell -> primitives and `unassigned`. 2D: the cells whose closure meets the primitive, exactly. 3D:
/// those and at times one that it misses by a rounding error (triangle_test.h).
void assign_primitives(CellComplex<2>& cells, const std::vector<Primitive<2>>& primitives,
                       const Progress& progress = {});
/// 3D throws InputError when that makes more than `most` references. On so many threads (0: as many as the machine
/// has); what comes out is the same from any number.
void assign_primitives(CellComplex<3>& cells, const std::vector<Primitive<3>>& primitives,
                       const Progress& progress = {}, std::size_t most = most_references, int threads = 0);

/// Word of the assignment, before each primitive; what takes time is said only now and then.
inline void report_assigned(const Progress& progress, std::size_t done, std::size_t count) {
    constexpr std::size_t block = std::size_t{1} << 12;
    if (done % block == 0)
        report(progress, "assigning to cells", static_cast<double>(done) / static_cast<double>(count));
}

/// A primitive that meets a cell.
struct CellPrimitive {
    std::uint32_t cell, primitive;
};

/// Compresses the pairs, which are sorted by primitive from part to part, into rows, and fills rho_max and rho_p95.
template <int D>
void set_cell_primitives(CellComplex<D>& cells, std::span<const std::vector<CellPrimitive>> parts, int threads = 0);

/// As locate(), but where several cells hold p it is not said which one comes back. Faster.
template <int D>
std::uint32_t any_holding(const CellComplex<D>& cells, const Vec<D>& p, std::uint32_t near = none);

/// Fills rho_max and rho_p95 from the rows.
template <int D>
void set_solidity_scales(CellComplex<D>& cells);

/// Fills border_cells.
template <int D>
void set_border_cells(CellComplex<D>& cells);

}  // namespace sightline
