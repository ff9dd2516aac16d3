// Space cut into convex cells, and which primitives each cell holds: flat arrays and indices only.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/lazy.h"
#include "core/base/made_once.h"
#include "core/geometry/predicates.h"
#include "core/space/box_tree.h"
#include "core/space/cell_rows.h"
#include "core/space/centroid_groups.h"
#include "core/space/tessellation.h"
#include "core/space/tree.h"

namespace sightline {

/// Cells are simplices (Delaunay) or boxes (leaves of a tree), so most rows have one length and need no begin array.
/// Those that do: row i of X is X[X_begin[i], X_begin[i + 1]).
template <int D>
struct CellComplex {
    Tessellation kind = Tessellation::delaunay;
    std::vector<Vec<D>> points;

    /// The corners of each cell. 2D: counter-clockwise; tetrahedra: orient() of them is +1.
    std::vector<std::uint32_t> cell_points;
    /// Those of each cell. Triangles: facet i joins corners i and i + 1; tetrahedra: it lies opposite corner i.
    std::vector<HalfFacet> half_facets;
    std::vector<std::uint32_t> cell_facet_begin;  ///< of boxes; empty for simplices

    /// The polygon that two cells share; 2D: two points, the cell of the side that is not flipped on their left. 3D:
    /// convex, counter-clockwise as that cell sees it from inside.
    std::vector<std::uint32_t> facet_points;
    std::vector<std::uint32_t> border_cells;  ///< ascending: those with a facet at the border of the tessellation

    std::vector<std::uint32_t> cell_primitive_begin{0};
    std::vector<std::uint32_t> cell_primitives;
    std::uint32_t rho_max = 0;     ///< the most primitives in one cell
    std::uint32_t rho_p95 = 0;     ///< 95th percentile of |A| over the cells that hold any
    std::uint32_t unassigned = 0;  ///< primitives that lie in no cell: never rendered

    Tree<D> tree;                          ///< the occupancy tree under the cells, interior nodes kept
    std::vector<std::uint32_t> leaf_cell;  ///< a cell at each leaf: where point location starts

    /// Of the scene that the cells are of; copies share it.
    std::shared_ptr<const SceneBoxes<D>> boxes = std::make_shared<const SceneBoxes<D>>();
    /// Copies of what runs read most, side by side in the order in which they do. Made anew with set_cell_primitives().
    struct Copies {
        Lazy<CellTriangles> triangles;    ///< 3D: of that scene, in the order of cell_primitives
        Lazy<LargeVector<CellRow>> rows;  ///< 3D
        Lazy<CentroidGroups<D>> groups;   ///< of that scene
    };
    std::shared_ptr<const Copies> copies = std::make_shared<const Copies>();
    /// Whatever else methods make once for that scene.
    std::shared_ptr<const MadeOnce> made = std::make_shared<const MadeOnce>();

    std::uint32_t cell_count() const {
        return static_cast<std::uint32_t>(has_boxes() ? cell_points.size() / (1 << D) : cell_points.size() / (D + 1));
    }
    std::uint32_t facet_count() const {
        return static_cast<std::uint32_t>(D == 3 && has_boxes() ? facet_points.size() / 4 : facet_points.size() / D);
    }

    std::span<const HalfFacet> facets_of(std::uint32_t cell) const {
        if (!has_boxes()) return std::span(half_facets).subspan((D + 1) * std::size_t{cell}, D + 1);
        return std::span(half_facets)
            .subspan(cell_facet_begin[cell], cell_facet_begin[cell + 1] - cell_facet_begin[cell]);
    }
    std::span<const std::uint32_t> corners_of(std::uint32_t cell) const {
        const std::size_t count = has_boxes() ? 1 << D : D + 1;
        return std::span(cell_points).subspan(count * cell, count);
    }
    std::span<const std::uint32_t> points_of_facet(std::uint32_t facet) const {
        const std::size_t count = D == 3 && has_boxes() ? 4 : D;
        return std::span(facet_points).subspan(count * facet, count);
    }
    /// An edge or a corner at which two boxes only touch (neighbours=touching). It stands among the facets, behind
    /// those of its cell, and has neither area nor normal.
    bool is_contact(std::uint32_t facet) const {
        const auto polygon = points_of_facet(facet);
        return polygon[D - 2] == polygon[D - 1];
    }
    /// The mean of the corners, rounded. Not stored: its corners are about to be read wherever it is asked for.
    Vec<D> centre(std::uint32_t cell) const {
        if (has_boxes()) return tree.nodes[tree.leaves[cell]].box.centre();
        Vec<D> sum(0);
        for (const std::uint32_t corner : corners_of(cell)) sum += points[corner];
        return sum / (D + 1.0);
    }
    std::span<const std::uint32_t> primitives_of(std::uint32_t cell) const {
        return std::span(cell_primitives)
            .subspan(cell_primitive_begin[cell], cell_primitive_begin[cell + 1] - cell_primitive_begin[cell]);
    }
    /// |A|
    std::uint32_t count(std::uint32_t cell) const {
        return cell_primitive_begin[cell + 1] - cell_primitive_begin[cell];
    }
    std::size_t memory_bytes() const;            ///< of the tessellation, without the references
    std::size_t reference_memory_bytes() const;  ///< of the lists cell -> primitives

    /// Leaves of a tree, so that cell i is leaf i.
    bool has_boxes() const { return kind != Tessellation::delaunay; }
};

/// The two ends of a 2D facet as `cell` sees it: the cell lies on the left of the path from [0] to [1].
inline std::array<Vec<2>, 2> facet_ends(const CellComplex<2>& cells, const HalfFacet& half) {
    const auto ends = cells.points_of_facet(half.facet());
    const Vec<2>&a = cells.points[ends[0]], &b = cells.points[ends[1]];
    if (half.flipped()) return {b, a};
    return {a, b};
}

inline const CellTriangles& triangles_of(const CellComplex<3>& cells, const Scene<3>& scene) {
    return cells.copies->triangles.of([&] { return CellTriangles(scene, cells.cell_primitives); });
}
template <int D>
const CentroidGroups<D>& centroid_groups_of(const CellComplex<D>& cells, const Scene<D>& scene) {
    return cells.copies->groups.of([&] { return centroid_groups<D>(scene); });
}
inline const LargeVector<CellRow>& cell_rows_of(const CellComplex<3>& cells) {
    return cells.copies->rows.of([&] { return cell_rows(cells); });
}

/// +1 when p lies strictly on the cell's side of its facet, 0 on the facet's line or plane, -1 beyond it. Exact.
inline int facet_side(const CellComplex<2>& cells, const HalfFacet& half, const Vec<2>& p) {
    const auto [a, b] = facet_ends(cells, half);
    return orient(a, b, p);
}
inline int facet_side(const CellComplex<3>& cells, const HalfFacet& half, const Vec<3>& p) {
    const auto polygon = cells.points_of_facet(half.facet());
    const int side = orient(cells.points[polygon[0]], cells.points[polygon[1]], cells.points[polygon[2]], p);
    return half.flipped() ? -side : side;
}

/// The cell whose closure holds p (the lowest index where several do), or none outside the tessellation. Exact.
/// `near`: a cell to start looking from, which makes it fast for points that lie close together; none: anywhere.
template <int D>
std::uint32_t locate(const CellComplex<D>& cells, const Vec<D>& p, std::uint32_t near = none);

/// Distance from p to the facet, rounded.
template <int D>
double distance_to_facet(const CellComplex<D>& cells, std::uint32_t facet, const Vec<D>& p);

/// Builds the tessellation that the settings ask for and gives every primitive to each cell whose closure it meets.
/// The Delaunay form has no cell when too few centres remain, or all lie on one line or plane (border = none).
template <int D>
CellComplex<D> build_cells(const Scene<D>& scene, const TessellationSettings& settings);

extern template CellComplex<2> build_cells<2>(const Scene<2>&, const TessellationSettings&);
extern template CellComplex<3> build_cells<3>(const Scene<3>&, const TessellationSettings&);

}  // namespace sightline
