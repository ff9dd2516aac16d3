// Space cut into convex cells, and which primitives each cell holds: flat arrays and indices only.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/predicates.h"
#include "core/settings/settings.h"
#include "core/space/tree.h"

namespace sightline {

/// One side of a facet, as a cell sees it.
struct HalfFacet {
    std::uint32_t neighbour = none;  ///< the cell on the other side; none at the border of the tessellation
    std::uint32_t facet_side = 0;    ///< facet * 2, + 1 when the facet's points turn the other way for this cell

    std::uint32_t facet() const { return facet_side >> 1; }
    bool flipped() const { return facet_side & 1; }
};

/// Rows are compressed: row i of X is X[X_begin[i], X_begin[i + 1]).
template <int D>
struct CellComplex {
    Tessellation kind = Tessellation::delaunay;
    std::vector<Vec<D>> points;
    std::vector<Vec<D>> centres;  ///< per cell: the mean of its corners

    std::vector<std::uint32_t> cell_facet_begin{0};
    std::vector<HalfFacet> half_facets;
    std::vector<std::uint32_t> cell_point_begin{0};
    std::vector<std::uint32_t> cell_points;  ///< the corners; 2D: counter-clockwise

    /// The polygon that two cells share; 2D: two points, the cell of the side that is not flipped on their left. 3D:
    /// convex, counter-clockwise as that cell sees it from inside.
    std::vector<std::uint32_t> facet_point_begin{0};
    std::vector<std::uint32_t> facet_points;

    std::vector<std::uint32_t> cell_primitive_begin{0};
    std::vector<std::uint32_t> cell_primitives;
    std::uint32_t rho_max = 0;     ///< the most primitives in one cell
    std::uint32_t rho_p95 = 0;     ///< 95th percentile of |A| over the cells that hold any
    std::uint32_t unassigned = 0;  ///< primitives that lie in no cell: never rendered

    Tree<D> tree;                          ///< the occupancy tree under the cells, interior nodes kept
    std::vector<std::uint32_t> leaf_cell;  ///< a cell at each leaf: where point location starts

    std::uint32_t cell_count() const { return static_cast<std::uint32_t>(centres.size()); }
    std::uint32_t facet_count() const { return static_cast<std::uint32_t>(facet_point_begin.size() - 1); }

    std::span<const HalfFacet> facets_of(std::uint32_t cell) const {
        return std::span(half_facets)
            .subspan(cell_facet_begin[cell], cell_facet_begin[cell + 1] - cell_facet_begin[cell]);
    }
    std::span<const std::uint32_t> corners_of(std::uint32_t cell) const {
        return std::span(cell_points)
            .subspan(cell_point_begin[cell], cell_point_begin[cell + 1] - cell_point_begin[cell]);
    }
    std::span<const std::uint32_t> points_of_facet(std::uint32_t facet) const {
        if constexpr (D == 2) return std::span(facet_points).subspan(2 * std::size_t{facet}, 2);
        return std::span(facet_points)
            .subspan(facet_point_begin[facet], facet_point_begin[facet + 1] - facet_point_begin[facet]);
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
    std::size_t reference_memory_bytes() const;  ///< of the lists primitive -> cell
};

/// The two ends of a 2D facet as `cell` sees it: the cell lies on the left of the path from [0] to [1].
inline std::array<Vec<2>, 2> facet_ends(const CellComplex<2>& cells, const HalfFacet& half) {
    const auto ends = cells.points_of_facet(half.facet());
    const Vec<2>&a = cells.points[ends[0]], &b = cells.points[ends[1]];
    if (half.flipped()) return {b, a};
    return {a, b};
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
/// The Delaunay form has no cell when fewer than three centres that are not collinear remain (border = none).
CellComplex<2> build_cells(const Scene<2>& scene, const Settings& settings);

}  // namespace sightline
