// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "core/space/builders.h"
#include "core/space/sample_points.h"

namespace sightline {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;
using Corners = std::array<std::uint32_t, 3>;

/// Counter-clockwise corner triples, lowest corner first, sorted: independent of CGAL's insertion order and memory.
std::vector<Corners> canonical_triangles(const std::vector<Vec<2>>& points) {
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> input;
    for (std::uint32_t i = 0; i < points.size(); ++i) input.emplace_back(Kernel::Point_2(points[i].x, points[i].y), i);
    Delaunay triangulation;
    triangulation.insert(input.begin(), input.end());
    std::vector<Corners> triangles;
    if (triangulation.dimension() < 2) return triangles;
    triangles.reserve(triangulation.number_of_faces());
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
        Corners c{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        triangles.push_back(c);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

void link_triangles(CellComplex<2>& cells) {
    std::unordered_map<std::uint64_t, std::uint32_t>
        open;  // directed edge (from, to) -> half facet waiting for its twin
    const auto edge = [](std::uint32_t from, std::uint32_t to) { return static_cast<std::uint64_t>(from) << 32 | to; };
    open.reserve(cells.cell_count() * 2);
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto corners = cells.corners_of(cell);
            const std::uint32_t from = corners[i], to = corners[(i + 1) % 3];
            const auto here = static_cast<std::uint32_t>(cells.half_facets.size());
            if (const auto twin = open.find(edge(to, from)); twin != open.end()) {
                HalfFacet& other = cells.half_facets[twin->second];
                other.neighbour = cell;
                cells.half_facets.push_back({twin->second / 3, other.facet_side | 1});
                open.erase(twin);
            } else {
                cells.half_facets.push_back({none, cells.facet_count() * 2});
                cells.facet_points.insert(cells.facet_points.end(), {from, to});
                open.emplace(edge(from, to), here);
            }
        }
}

}  // namespace

CellComplex<2> delaunay_cells(Tree<2> tree, const TessellationSettings& settings) {
    CellComplex<2> cells;
    cells.kind = Tessellation::delaunay;
    cells.points = sample_points(tree, settings);
    for (const Corners& corners : canonical_triangles(cells.points))
        cells.cell_points.insert(cells.cell_points.end(), corners.begin(), corners.end());
    set_leaf_cells(cells, tree, settings);
    link_triangles(cells);
    tree.empty_leaves = {};
    cells.tree = std::move(tree);
    set_border_cells(cells);
    return cells;
}

}  // namespace sightline
