// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/solid_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/space/builders.h"
#include "tests/space/random_cells.h"

namespace sightline {
namespace {

using Point = std::array<double, 3>;
Point key(const Vec<3>& p) { return {p.x, p.y, p.z}; }

std::vector<Point> sorted(std::vector<Point> points) {
    std::sort(points.begin(), points.end());
    return points;
}

struct Face {
    std::uint32_t cell;
    std::uint8_t style;
};

/// Faces by their points in any order.
std::multimap<std::vector<Point>, Face> faces_of(const SolidList& list) {
    std::multimap<std::vector<Point>, Face> faces;
    EXPECT_EQ(list.face_begin.size(), list.face_style.size() + 1);
    EXPECT_EQ(list.face_cell.size(), list.face_style.size());
    for (std::size_t i = 0; i < list.face_style.size(); ++i) {
        std::vector<Point> points;
        for (std::uint32_t p = list.face_begin[i]; p < list.face_begin[i + 1]; ++p)
            points.push_back(key(list.points[p]));
        faces.insert({sorted(points), {list.face_cell[i], list.face_style[i]}});
    }
    return faces;
}

/// Edges by their ends in any order, with their styles.
std::multimap<std::vector<Point>, std::uint8_t> edges_by_ends(const SolidList& list) {
    std::multimap<std::vector<Point>, std::uint8_t> edges;
    EXPECT_EQ(list.edge_points.size(), 2 * list.edge_style.size());
    for (std::size_t i = 0; i < list.edge_style.size(); ++i)
        edges.insert({sorted({key(list.edge_points[2 * i]), key(list.edge_points[2 * i + 1])}), list.edge_style[i]});
    return edges;
}

/// Groups in runs of neighbouring cells, each drawn in one way; styles differ inside some groups, as in heat maps.
std::vector<CellPaint> random_paint(const CellComplex<3>& cells, Random& random) {
    std::array<DrawnAs, 5> as;
    for (DrawnAs& way : as) way = static_cast<DrawnAs>(random.below(4));
    const bool heat = random.below(3) == 0, border = random.below(2) == 0;
    std::vector<CellPaint> paint(cells.cell_count());
    std::uint8_t group = 0;
    for (CellPaint& cell : paint) {
        if (random.below(3) == 0) group = static_cast<std::uint8_t>(random.below(5));
        cell.group = group;
        cell.as = as[group];
        cell.style = static_cast<std::uint8_t>(heat ? 10 + random.below(32) : group);
        if (border) cell.border = 7;
    }
    return paint;
}

bool with_faces(const CellPaint& paint) { return paint.as == DrawnAs::solid || paint.as == DrawnAs::translucent; }

/// The two cells of each facet; the second is none at the border.
std::vector<std::array<std::uint32_t, 2>> sides_of_facets(const CellComplex<3>& cells) {
    std::vector<std::array<std::uint32_t, 2>> sides(cells.facet_count(), {none, none});
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        for (const HalfFacet& half : cells.facets_of(cell)) sides[half.facet()][sides[half.facet()][0] != none] = cell;
    return sides;
}

TEST(SolidCells, AFaceLiesBetweenACellAndWhatIsDrawnInAnotherWay) {
    Random random(301);
    for (int i = 0; i < 80; ++i) {
        const CellComplex<3> cells = test::random_cells(random);
        const std::vector<CellPaint> paint = random_paint(cells, random);
        SolidList list;
        add_cells(cells, paint, 1, list);
        const auto faces = faces_of(list);
        std::size_t expected = 0;
        const auto sides = sides_of_facets(cells);
        for (std::uint32_t facet = 0; facet < sides.size(); ++facet) {
            std::vector<Point> points;
            for (const std::uint32_t p : cells.points_of_facet(facet)) points.push_back(key(cells.points[p]));
            std::vector<std::uint32_t> bodies;
            for (const std::uint32_t cell : sides[facet])
                if (cell != none && with_faces(paint[cell])) bodies.push_back(cell);
            const auto [first, last] = faces.equal_range(sorted(points));
            const auto drawn = std::distance(first, last);
            const bool alike = bodies.size() == 2 && paint[bodies[0]].group == paint[bodies[1]].group;
            ASSERT_EQ(drawn, !bodies.empty() && !alike);
            if (drawn == 0) continue;
            ++expected;
            const std::uint32_t owner = first->second.cell;
            ASSERT_TRUE(std::find(bodies.begin(), bodies.end(), owner) != bodies.end());
            ASSERT_EQ(first->second.style, paint[owner].style);
            // Glass in front of a wall leaves the wall.
            for (const std::uint32_t cell : bodies)
                if (paint[cell].as == DrawnAs::solid) {
                    ASSERT_EQ(paint[owner].as, DrawnAs::solid);
                }
        }
        ASSERT_EQ(faces.size(), expected);
    }
}

TEST(SolidCells, AnEdgeIsDrawnOnceAndWireGoesBeforeBorder) {
    Random random(302);
    for (int i = 0; i < 80; ++i) {
        const CellComplex<3> cells = test::random_cells(random);
        const std::vector<CellPaint> paint = random_paint(cells, random);
        SolidList list;
        add_cells(cells, paint, 1, list);
        // Ends of an edge of a box differ in one coordinate; in a tetrahedron all pairs are edges.
        std::map<std::vector<Point>, std::set<std::uint8_t>> wire;
        for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
            if (paint[cell].as == DrawnAs::wireframe)
                for (const std::uint32_t a : cells.corners_of(cell))
                    for (const std::uint32_t b : cells.corners_of(cell)) {
                        const Vec<3>&p = cells.points[a], &q = cells.points[b];
                        const int apart = (p.x != q.x) + (p.y != q.y) + (p.z != q.z);
                        if (a < b && (cells.kind == Tessellation::delaunay || apart == 1))
                            wire[sorted({key(p), key(q)})].insert(paint[cell].style);
                    }
        std::set<std::vector<Point>> all;
        for (const auto& [ends, styles] : wire) all.insert(ends);
        for (std::size_t face = 0; face < list.face_style.size(); ++face)
            if (paint[list.face_cell[face]].border != no_style) {
                const std::uint32_t begin = list.face_begin[face], size = list.face_begin[face + 1] - begin;
                for (std::uint32_t k = 0; k < size; ++k)
                    all.insert(sorted({key(list.points[begin + k]), key(list.points[begin + (k + 1) % size])}));
            }
        const auto edges = edges_by_ends(list);
        ASSERT_EQ(edges.size(), all.size());
        for (const auto& [ends, style] : edges) {
            ASSERT_TRUE(all.contains(ends));
            if (const auto found = wire.find(ends); found != wire.end()) {
                ASSERT_TRUE(found->second.contains(style));
            } else {
                ASSERT_EQ(style, 7);
            }
        }
    }
}

TEST(SolidCells, ShrunkCellsAreBodiesInsideTheirCells) {
    Random random(303);
    for (int i = 0; i < 60; ++i) {
        const CellComplex<3> cells = test::random_cells(random);
        const std::vector<CellPaint> paint = random_paint(cells, random);
        const double shrink = random.uniform(0.05, 0.99);
        SolidList list;
        add_cells(cells, paint, shrink, list);
        const bool boxes = cells.kind == Tessellation::tree;
        std::size_t faces = 0, edges = 0;
        for (const CellPaint& cell : paint) {
            faces += with_faces(cell) ? (boxes ? 6u : 4u) : 0u;
            if (cell.as == DrawnAs::wireframe || (with_faces(cell) && cell.border != no_style)) edges += boxes ? 12 : 6;
        }
        ASSERT_EQ(list.face_style.size(), faces);
        ASSERT_EQ(list.edge_style.size(), edges);
        std::map<std::uint32_t, std::map<Point, int>> corners;  // per cell, in how many of its faces
        for (std::size_t face = 0; face < faces; ++face) {
            const std::uint32_t cell = list.face_cell[face];
            ASSERT_EQ(list.face_style[face], paint[cell].style);
            const std::uint32_t begin = list.face_begin[face], size = list.face_begin[face + 1] - begin;
            ASSERT_EQ(size, boxes ? 4u : 3u);
            for (std::uint32_t k = 0; k < size; ++k) {
                const Vec<3>& p = list.points[begin + k];
                for (const HalfFacet& half : cells.facets_of(cell)) ASSERT_EQ(facet_side(cells, half, p), 1);
                ++corners[cell][key(p)];
                const Vec<3> corner = cells.centre(cell) + (p - cells.centre(cell)) / shrink;
                ASSERT_TRUE(std::any_of(cells.corners_of(cell).begin(), cells.corners_of(cell).end(),
                                        [&](std::uint32_t c) { return glm::length(cells.points[c] - corner) < 1e-9; }));
            }
            // Flat, convex and turning one way round: no bow ties.
            if (boxes) {
                const auto corner = [&](std::uint32_t k) { return list.points[begin + k % 4]; };
                const Vec<3> n = glm::cross(corner(1) - corner(0), corner(2) - corner(1));
                for (std::uint32_t k = 1; k < 4; ++k)
                    ASSERT_GT(glm::dot(n, glm::cross(corner(k + 1) - corner(k), corner(k + 2) - corner(k + 1))), 0);
            }
        }
        // A closed body: three faces meet at each corner of a tetrahedron or a box.
        for (const auto& [cell, points] : corners) {
            ASSERT_EQ(points.size(), boxes ? 8u : 4u);
            for (const auto& [point, meeting] : points) ASSERT_EQ(meeting, 3);
        }
        for (std::size_t edge = 0; edge < edges; ++edge) {
            const Vec<3> along = list.edge_points[2 * edge + 1] - list.edge_points[2 * edge];
            if (boxes) {
                ASSERT_EQ((along.x != 0) + (along.y != 0) + (along.z != 0), 1);
            }
        }
    }
}

TEST(SolidCells, NothingIsAddedForNothing) {
    const CellComplex<3> cells;
    SolidList list;
    add_cells(cells, {}, 1, list);
    add_cells(cells, {}, 0.5, list);
    EXPECT_TRUE(list.points.empty() && list.edge_points.empty() && list.face_style.empty());
}

}  // namespace
}  // namespace sightline
