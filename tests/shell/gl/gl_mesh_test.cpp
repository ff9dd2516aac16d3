// Draw lists as triangles, without OpenGL: places, order, runs, and triangulated polygons.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/random.h"
#include "shell/gl/list_mesh.h"
#include "shell/gl/triangulate.h"

namespace sightline {
namespace {

constexpr Colour red{255, 0, 0}, blue{0, 0, 255};

DrawList mesh_list(const std::vector<Style>& styles) {
    DrawList list;
    list.world = {{0, 0}, {100, 50}};
    list.styles = styles;
    return list;
}

Style filled_style(Colour colour) {
    Style style;
    style.fill = colour;
    return style;
}

Style stroked_style(Colour colour, double width, Dash dash = Dash::solid) {
    Style style;
    style.stroke = colour;
    style.width_pt = width;
    style.dash = dash;
    return style;
}

ListMesh mesh_of(const DrawList& list) {
    ListMesh mesh;
    make_mesh(list, mesh);
    return mesh;
}

TEST(ListMesh, PlacesAreRelativeToTheMiddleOfWhatIsShown) {
    DrawList list = mesh_list({filled_style(red)});
    list.world = {{1e9, 1e9}, {1e9 + 2, 1e9 + 2}};
    list.add(ShapeKind::polygon, 0, {{1e9, 1e9}, {1e9 + 1.25, 1e9}, {1e9, 1e9 + 2}});
    const ListMesh mesh = mesh_of(list);
    EXPECT_EQ(mesh.origin, Vec<2>(1e9 + 1, 1e9 + 1));
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[1].x, 0.25f);
    EXPECT_EQ(mesh.vertices[1].y, -1.0f);
    EXPECT_EQ(mesh.vertices[1].colour, red);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(ListMesh, ALineIsAQuadThatKnowsItsWidthAndLength) {
    DrawList list = mesh_list({stroked_style(blue, 3, Dash::dashed)});
    list.add(ShapeKind::polyline, 0, {{10, 20}, {13, 24}, {13, 30}});
    const ListMesh mesh = mesh_of(list);
    ASSERT_EQ(mesh.vertices.size(), 8u);
    EXPECT_EQ(mesh.indices.size(), 12u);
    for (std::size_t i = 0; i < 8; ++i) {
        const MeshVertex& v = mesh.vertices[i];
        EXPECT_EQ(v.paint, Paint::dashed);
        EXPECT_EQ(v.half_width, 1.5 * mesh_units_per_pt);
        EXPECT_EQ(v.corner, i % 4);
        EXPECT_EQ(v.length, i < 4 ? 5 : 6);
        EXPECT_EQ(v.start, i < 4 ? 0 : 5);  // dashes go on around the corner
    }
    EXPECT_EQ(mesh.vertices[0].x, 10 - 50);
    EXPECT_EQ(mesh.vertices[1].y, 24 - 25);
    EXPECT_NEAR(mesh.vertices[0].dx / 127.0, 0.6, 0.01);
    EXPECT_NEAR(mesh.vertices[0].dy / 127.0, 0.8, 0.01);
    EXPECT_EQ(mesh.vertices[4].dy, 127);
}

TEST(ListMesh, LinesAreAtLeastAsThickAsInFigures) {
    DrawList list = mesh_list({stroked_style(blue, 0.1)});
    list.add(ShapeKind::polyline, 0, {{1, 1}, {2, 2}});
    EXPECT_EQ(mesh_of(list).vertices[0].half_width, 0.25 * mesh_units_per_pt);
}

TEST(ListMesh, RunsKeepTheOrderOfShapesAndStayFew) {
    Style both = filled_style(red);
    both.stroke = blue;
    DrawList list = mesh_list({filled_style(red), stroked_style(blue, 1), both});
    const auto cell = [&](std::uint16_t style) { list.add(ShapeKind::polygon, style, {{0, 0}, {1, 0}, {0, 1}}); };
    for (int i = 0; i < 1000; ++i) cell(0);
    for (int i = 0; i < 1000; ++i) list.add(ShapeKind::polyline, 1, {{0, 0}, {1, 1}});
    for (int i = 0; i < 3000; ++i) cell(2);
    const ListMesh mesh = mesh_of(list);
    ASSERT_GE(mesh.runs.size(), 3u);
    EXPECT_LT(mesh.runs.size(), 20u);
    EXPECT_EQ(mesh.runs[0].kind, MeshRun::Kind::fills);
    EXPECT_TRUE(mesh.runs[0].opaque);
    EXPECT_EQ(mesh.runs[0].count, 3000u);
    EXPECT_EQ(mesh.runs[1].kind, MeshRun::Kind::lines);
    EXPECT_EQ(mesh.runs[1].count, 6000u);
    std::uint32_t next = 0;
    for (const MeshRun& run : mesh.runs) {
        EXPECT_EQ(run.first, next);
        next += run.count;
        for (std::uint32_t i = run.first; i < next; ++i) {
            const Paint paint = mesh.vertices[mesh.indices[i]].paint;
            if (run.kind == MeshRun::Kind::fills) {
                EXPECT_EQ(paint, Paint::fill);
            }
            if (run.kind == MeshRun::Kind::lines) {
                EXPECT_EQ(paint, Paint::solid);
            }
        }
    }
    EXPECT_EQ(next, mesh.indices.size());
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint32_t lowest = std::min({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
        ASSERT_GE(lowest, before);
        before = lowest;
    }
}

TEST(ListMesh, WhatCannotBeDrawnIsLeftOut) {
    DrawList list = mesh_list({filled_style(red), stroked_style(blue, 1)});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    list.add(ShapeKind::polygon, 7, {{0, 0}, {1, 0}, {0, 1}});      // no such style
    list.add(ShapeKind::polygon, 0, {{0, 0}, {1, 0}});              // too few points
    list.add(ShapeKind::polygon, 0, {{0, 0}, {1e300, 0}, {0, 1}});  // absurd
    list.add(ShapeKind::polyline, 1, {{0, 0}, {nan, 0}});           //
    list.add(ShapeKind::polyline, 0, {{0, 0}, {1, 0}});             // nothing to stroke with
    list.add(ShapeKind::disc, 0, {{0, 0}}, 0);                      // no size
    list.add(ShapeKind::arrow, 1, {{3, 3}, {3, 3}}, 4);             // no direction
    list.shapes.push_back({ShapeKind::polyline, 1, 0, 1000});       // no such points
    list.shapes.push_back({ShapeKind::polyline, 1, 4'000'000'000u, 4'000'000'000u});
    const ListMesh mesh = mesh_of(list);
    EXPECT_TRUE(mesh.vertices.empty());
    EXPECT_TRUE(mesh.indices.empty());
    EXPECT_TRUE(mesh.runs.empty());
}

double area_of(std::span<const Vec<2>> p, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return std::abs(cross(p[b] - p[a], p[c] - p[a])) / 2;
}

TEST(Triangulate, TrianglesCoverAnySimplePolygonOnce) {
    Random random(5);
    for (int round = 0; round < 300; ++round) {
        // A star around a centre is simple, seldom convex; turned either way.
        std::vector<Vec<2>> polygon;
        const std::size_t n = 3 + random.below(20);
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
            const double radius = 0.2 + static_cast<double>(random.below(1000)) / 500;
            polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        if (random.below(2)) std::reverse(polygon.begin(), polygon.end());
        double area = 0;
        for (std::size_t i = 0; i < n; ++i) area += cross(polygon[i], polygon[(i + 1) % n]) / 2;
        std::vector<std::uint32_t> triangles;
        triangulate(polygon, triangles);
        ASSERT_EQ(triangles.size(), 3 * (n - 2));
        double sum = 0;
        for (std::size_t i = 0; i < triangles.size(); i += 3)
            sum += area_of(polygon, triangles[i], triangles[i + 1], triangles[i + 2]);
        EXPECT_NEAR(sum, std::abs(area), 1e-9) << "round " << round;
    }
}

TEST(Triangulate, ADamagedPolygonGivesTrianglesToo) {
    const std::array<Vec<2>, 6> bow{Vec<2>{0, 0}, {4, 4}, {4, 0}, {0, 4}, {0, 4}, {2, 2}};
    std::vector<std::uint32_t> triangles;
    triangulate(bow, triangles);
    EXPECT_EQ(triangles.size(), 12u);
    for (const std::uint32_t i : triangles) EXPECT_LT(i, 6u);
}

}  // namespace
}  // namespace sightline
