// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>

#include "core/space/builders.h"
#include "core/space/sample_points.h"
#include "core/space/tetrahedron.h"

namespace sightline {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

/// A cell of CGAL's under its canonical name, which does not depend on CGAL's insertion order and memory: its corners
/// ascending, the last two exchanged where orient() asks for it.
struct Tetrahedron {
    std::array<std::uint32_t, 4> corners;
    std::array<std::uint8_t, 4> place;  ///< of each corner in CGAL's cell
    Delaunay::Cell_handle cell;
};

Tetrahedron canonical(Delaunay::Cell_handle cell) {
    Tetrahedron t{{}, {0, 1, 2, 3}, cell};
    const auto corner = [&](std::uint8_t place) { return cell->vertex(place)->info(); };
    bool odd = false;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            if (corner(t.place[j]) < corner(t.place[i])) {
                std::swap(t.place[i], t.place[j]);
                odd = !odd;
            }
    if (odd) std::swap(t.place[2], t.place[3]);  // CGAL's own order is positive
    for (std::size_t i = 0; i < 4; ++i) t.corners[i] = corner(t.place[i]);
    return t;
}

/// The finite cells in canonical order; each handle's info is its index there, `none` for infinite cells.
std::vector<Tetrahedron> canonical_tetrahedra(Delaunay& triangulation) {
    std::vector<Tetrahedron> tetrahedra;
    if (triangulation.dimension() < 3) return tetrahedra;
    tetrahedra.reserve(triangulation.number_of_finite_cells());
    for (const Delaunay::Cell_handle cell : triangulation.all_cell_handles()) {
        cell->info() = none;
        if (!triangulation.is_infinite(cell)) tetrahedra.push_back(canonical(cell));
    }
    std::sort(tetrahedra.begin(), tetrahedra.end(),
              [](const Tetrahedron& a, const Tetrahedron& b) { return a.corners < b.corners; });
    for (std::uint32_t i = 0; i < tetrahedra.size(); ++i) tetrahedra[i].cell->info() = i;
    return tetrahedra;
}

void link(CellComplex<3>& cells, const std::vector<Tetrahedron>& tetrahedra) {
    cells.half_facets.resize(tetrahedra.size() * 4);
    for (std::uint32_t cell = 0; cell < tetrahedra.size(); ++cell) {
        const Tetrahedron& t = tetrahedra[cell];
        for (std::size_t i = 0; i < 4; ++i) {
            HalfFacet& half = cells.half_facets[4 * std::size_t{cell} + i];
            if (half.neighbour != none) continue;  // linked from the neighbour, which comes before
            half.facet_side = cells.facet_count() * 2;
            for (const std::size_t corner : facet_corners[i]) cells.facet_points.push_back(t.corners[corner]);
            const Delaunay::Cell_handle behind = t.cell->neighbor(t.place[i]);
            half.neighbour = behind->info();
            if (half.neighbour == none) continue;
            const auto& place = tetrahedra[half.neighbour].place;
            const auto back = std::find(place.begin(), place.end(), behind->index(t.cell)) - place.begin();
            cells.half_facets[4 * std::size_t{half.neighbour} + static_cast<std::size_t>(back)] = {cell,
                                                                                                   half.facet_side | 1};
        }
    }
}

}  // namespace

CellComplex<3> delaunay_cells(Tree<3> tree, const TessellationSettings& settings) {
    CellComplex<3> cells;
    cells.kind = Tessellation::delaunay;
    cells.points = sample_points(tree, settings);
    std::vector<std::pair<Kernel::Point_3, std::uint32_t>> input;
    input.reserve(cells.points.size());
    for (const Vec<3>& p : cells.points)
        input.emplace_back(Kernel::Point_3(p.x, p.y, p.z), static_cast<std::uint32_t>(input.size()));
    Delaunay triangulation;
    triangulation.insert(input.begin(), input.end());
    const std::vector<Tetrahedron> tetrahedra = canonical_tetrahedra(triangulation);
    cells.cell_points.reserve(tetrahedra.size() * 4);
    for (const Tetrahedron& t : tetrahedra)
        cells.cell_points.insert(cells.cell_points.end(), t.corners.begin(), t.corners.end());
    cells.facet_points.reserve(tetrahedra.size() * 6 + 48);
    set_leaf_cells(cells, tree, settings);
    link(cells, tetrahedra);
    cells.facet_points.shrink_to_fit();
    tree.empty_leaves = {};
    cells.tree = std::move(tree);
    set_border_cells(cells);
    return cells;
}

}  // namespace sightline
