// Polygons out of triangles: convex, of one plane, and what they share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/polygons.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "core/scene/make/catalogue.h"
#include "tests/scene/random_scene.h"

namespace sightline {
namespace {

/// Four corners in a plane, cut along a diagonal.
void add_quad(Scene<3>& scene, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
    scene.primitives.push_back({a, b, c});
    scene.primitives.push_back({a, c, d});
}

Scene<3> box_of_triangles() {
    Scene<3> scene;
    const Box<3> box{Vec<3>(0), Vec<3>(1, 2, 3)};
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : faces) add_quad(scene, box.corner(a), box.corner(b), box.corner(c), box.corner(d));
    return scene;
}

TEST(Polygons, SidesOfABox) {
    const Polygons<3> polygons = build_polygons(box_of_triangles());
    ASSERT_EQ(polygons.size(), 6u);
    EXPECT_EQ(polygons.points.size(), 8u);
    EXPECT_EQ(polygons.edge_count, 12u);
    std::map<std::uint32_t, int> at_edge, direction;
    for (std::uint32_t p = 0; p < 6; ++p) {
        EXPECT_EQ(polygons.sides_of(p).size(), 4u);
        EXPECT_EQ(polygons.members_of(p).size(), 2u);
        EXPECT_EQ(polygons.planes_of(p).size(), 1u);
        for (const auto& side : polygons.sides_of(p)) {
            ++at_edge[side.edge];
            direction[side.edge] += side.reversed ? -1 : 1;
        }
        // The front looks out of the box.
        EXPECT_GT(glm::dot(polygons.area[p], polygons.centre[p] - Vec<3>(0.5, 1, 1.5)), 0);
    }
    for (const auto& [edge, count] : at_edge) EXPECT_EQ(count, 2) << "two sides of a closed solid meet at each edge";
    for (const auto& [edge, sum] : direction) EXPECT_EQ(sum, 0) << "and run along it in opposite directions";
}

TEST(Polygons, AGridBecomesOnePolygonAndAnLDoesNot) {
    Scene<3> grid, corner;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 2; ++y) {
            Scene<3>* const both[] = {&grid, x == 2 && y == 1 ? nullptr : &corner};
            for (Scene<3>* scene : both)
                if (scene) add_quad(*scene, {x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0});
        }
    const Polygons<3> one = build_polygons(grid);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one.sides_of(0).size(), 10u) << "corners of the grid on the border stay: others may meet there";
    EXPECT_DOUBLE_EQ(one.area[0].z, 6);
    EXPECT_EQ(build_polygons(corner).size(), 2u);
}

TEST(Polygons, TwoSidedAndOneSidedStayApartAndSoDoOppositeTurns) {
    Scene<3> scene;
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    scene.two_sided = {1, 0};
    EXPECT_EQ(build_polygons(scene).size(), 2u);
    scene.two_sided = {1, 1};
    EXPECT_EQ(build_polygons(scene).size(), 1u);
    std::swap(scene.primitives[1][0], scene.primitives[1][1]);
    EXPECT_EQ(build_polygons(scene).size(), 2u);
}

TEST(Polygons, RoundingToFloatsDoesNotPartARectangleAndAFoldDoes) {
    Random random(71);
    for (int i = 0; i < 200; ++i) {
        const Vec<3> at(random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(0, 20));
        const double turn = random.uniform(-1, 1), up = random.uniform(0.5, 3);
        const Vec<3> along = Vec<3>(std::sqrt(1 - turn * turn), turn, 0) * random.uniform(1, 9), high(0, 0, up);
        const auto rounded = [](Vec<3> p) {
            for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(p[k]);
            return p;
        };
        Scene<3> scene;
        add_quad(scene, rounded(at), rounded(at + along), rounded(at + along + high), rounded(at + high));
        EXPECT_EQ(build_polygons(scene).size(), 1u) << i;
        scene.primitives[1][2] += Vec<3>(-turn, std::sqrt(1 - turn * turn), 0) * 0.01;
        EXPECT_EQ(build_polygons(scene).size(), 2u) << i;
    }
}

// Two floors meet along a line on which their corners differ: the border of both would run back along itself.
TEST(Polygons, AreNotJoinedToOneThatGoesBackAlongItsBorder) {
    Scene<3> scene;
    const auto add = [&](const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
        scene.primitives.push_back({Vec<3>(a.x, a.y, 0), Vec<3>(b.x, b.y, 0), Vec<3>(c.x, c.y, 0)});
    };
    add({0, 0}, {3, 0}, {3, 1});
    add({0, 0}, {3, 1}, {2, 1});
    add({0, 0}, {2, 1}, {0, 1});
    add({2, 2}, {1, 1}, {2, 1});
    add({2, 2}, {2, 1}, {3, 1});
    EXPECT_EQ(build_polygons(scene).size(), 2u);
}

/// In any scene: each triangle in one polygon, all corners of a polygon on its planes but for the tolerance, its loop
/// convex as seen along its normal, its area that of its members.
void check_polygons(const Scene<3>& scene) {
    const Polygons<3> polygons = build_polygons(scene);
    double largest = 0;
    for (const Primitive<3>& t : scene.primitives)
        for (const Vec<3>& p : t)
            for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
    const double tolerance = largest * 0x1p-18;
    std::size_t members = 0;
    for (std::uint32_t p = 0; p < polygons.size(); ++p) {
        Vec<3> area(0);
        for (const std::uint32_t member : polygons.members_of(p)) {
            ASSERT_EQ(polygons.polygon_of[member], p);
            const Primitive<3>& t = scene.primitives[member];
            area += glm::cross(t[1] - t[0], t[2] - t[0]) / 2.0;
            ++members;
            const auto planes = polygons.planes_of(p);
            ASSERT_TRUE(std::any_of(planes.begin(), planes.end(), [&](std::uint32_t plane) {
                const Primitive<3>& o = scene.primitives[plane];
                return std::all_of(t.begin(), t.end(),
                                   [&](const Vec<3>& corner) { return orient(o[0], o[1], o[2], corner) == 0; });
            })) << "a member's plane is among those that are asked";
        }
        const double size = std::sqrt(glm::dot(area, area));
        ASSERT_LE(glm::dot(area - polygons.area[p], area - polygons.area[p]), 1e-18 * (1 + size * size));
        if (size == 0) continue;
        const std::vector<Vec<3>> loop = polygons.corners_of(p);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec<3>&a = loop[i], &b = loop[(i + 1) % loop.size()];
            for (const Vec<3>& c : loop)
                ASSERT_GE(glm::dot(glm::cross(b - a, c - a), area) / size,
                          -tolerance * std::sqrt(glm::dot(b - a, b - a)) - 1e-12)
                    << scene.id << ' ' << p;
        }
    }
    ASSERT_EQ(members, scene.primitives.size());
}

TEST(Polygons, AreConvexAndHoldTheirMembersInAllScenes) {
    Random random(72);
    for (int i = 0; i < 30; ++i) check_polygons(test::random_scene_3d(random, 200));
    for (const CatalogueRow<3>& row : catalogue<3>()) check_polygons(make_scene(row, 20'000));
}

TEST(Polygons, SegmentsShareTheirEnds) {
    Scene<2> scene;
    scene.primitives = {{Vec<2>(0, 0), Vec<2>(1, 0)}, {Vec<2>(2, 1), Vec<2>(1, 0)}, {Vec<2>(5, 5), Vec<2>(6, 6)}};
    const Polygons<2> polygons = build_polygons(scene);
    ASSERT_EQ(polygons.size(), 3u);
    EXPECT_EQ(polygons.sides_of(0)[1].edge, polygons.sides_of(1)[1].edge);
    std::set<std::uint32_t> edges;
    for (const auto& side : polygons.sides) edges.insert(side.edge);
    EXPECT_EQ(edges.size(), 5u);
    EXPECT_EQ(polygons.area[0], Vec<2>(0, 1)) << "to the left of the way from start to end";
}

}  // namespace
}  // namespace sightline
