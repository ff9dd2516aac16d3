// Polygons cut into triangles: their number, their area, and that it ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read/cut_polygon.h"

#include <gtest/gtest.h>

#include <map>

#include "core/base/random.h"
#include "core/base/trig.h"

namespace sightline {
namespace {

using Corners = std::vector<Vec<3>>;

std::vector<Primitive<3>> cut_into(const Corners& corners) {
    std::vector<Primitive<3>> triangles;
    EXPECT_TRUE(PolygonCutter(0).cut(corners, triangles));
    return triangles;
}

double area_of(const Primitive<3>& t, const Vec<3>& normal) {
    return glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), normal) / 2;
}

/// All triangles turn as the polygon does, and together have its area: none overlap.
void expect_cut(const Corners& corners, const Vec<3>& normal, double area) {
    const std::vector<Primitive<3>> triangles = cut_into(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    double sum = 0;
    for (const Primitive<3>& t : triangles) {
        EXPECT_GT(area_of(t, normal), 0);
        sum += area_of(t, normal);
    }
    EXPECT_NEAR(sum, area, 1e-9 * area);
}

/// A star-shaped polygon about zero in the plane z = 0.
Corners star(std::size_t corners, double inner) {
    Corners result;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(corners), radius = i % 2 ? inner : 1;
        result.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return result;
}

double star_area(std::size_t corners, double inner) {
    return static_cast<double>(corners) / 2 * inner * std::sin(2 * pi / static_cast<double>(corners));
}

TEST(CutPolygon, FansOfConvexOnes) {
    EXPECT_EQ(cut_into({Vec<3>(0), Vec<3>(1, 0, 0)}).size(), 0u);
    const Corners c = star(6, 1);
    EXPECT_EQ(cut_into({c[0], c[1], c[2]}), (std::vector<Primitive<3>>{{c[0], c[1], c[2]}}));
    EXPECT_EQ(cut_into({c[0], c[1], c[2], c[3]}), (std::vector<Primitive<3>>{{c[0], c[1], c[2]}, {c[0], c[2], c[3]}}));
    EXPECT_EQ(cut_into({c[0], c[1], c[2], c[3], c[4]}),
              (std::vector<Primitive<3>>{{c[4], c[0], c[1]}, {c[4], c[1], c[2]}, {c[4], c[2], c[3]}}));
}

TEST(CutPolygon, OnesThatAreNotConvexFromEveryCornerAndSide) {
    const std::vector<std::pair<Corners, double>> polygons = {
        {{Vec<3>(0), Vec<3>(4, 0, 0), Vec<3>(1, 1, 0), Vec<3>(0, 4, 0)}, 4},
        {{Vec<3>(0), Vec<3>(4, 0, 0), Vec<3>(4, 4, 0), Vec<3>(2, 1, 0), Vec<3>(0, 4, 0)}, 10},
        {{Vec<3>(0), Vec<3>(3, 0, 0), Vec<3>(3, 3, 0), Vec<3>(2, 3, 0), Vec<3>(2, 1, 0), Vec<3>(1, 1, 0),
          Vec<3>(1, 3, 0), Vec<3>(0, 3, 0)},
         7},
        // Corners on straight edges: no triangle is without area.
        {{Vec<3>(0), Vec<3>(1, 0, 0), Vec<3>(2, 0, 0), Vec<3>(2, 2, 0)}, 2},
        {{Vec<3>(0), Vec<3>(1, 0, 0), Vec<3>(2, 0, 0), Vec<3>(2, 1, 0), Vec<3>(2, 2, 0), Vec<3>(0, 2, 0)}, 4},
        // A hole, reached along one edge there and back.
        {{Vec<3>(0), Vec<3>(4, 0, 0), Vec<3>(4, 4, 0), Vec<3>(0, 4, 0), Vec<3>(0), Vec<3>(1, 1, 0), Vec<3>(1, 2, 0),
          Vec<3>(2, 2, 0), Vec<3>(2, 1, 0), Vec<3>(1, 1, 0)},
         15},
        {star(40, 0.3), star_area(40, 0.3)}};
    for (std::size_t which = 0; which < polygons.size(); ++which)
        for (std::size_t first = 0; first < polygons[which].first.size(); ++first)
            for (int axis = 0; axis < 3; ++axis)
                for (const bool back : {false, true}) {
                    SCOPED_TRACE(std::to_string(which) + " from " + std::to_string(first));
                    Corners corners = polygons[which].first;
                    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(first), corners.end());
                    if (back) std::reverse(corners.begin(), corners.end());
                    for (Vec<3>& p : corners)  // also askew and far away
                        p = Vec<3>(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) + Vec<3>(1 << 20, 3, -(1 << 20));
                    Vec<3> normal(0);
                    normal[(5 - axis) % 3] = back ? -1 : 1;
                    expect_cut(corners, normal, polygons[which].second);
                }
}

/// Twice the area, of a polygon in the plane z = 0.
double shoelace(const Corners& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) sum += glm::cross(corners[i], corners[(i + 1) % corners.size()]).z;
    return sum;
}

TEST(CutPolygon, OnesOfManyCornersInEachOthersWay) {
    Random random(3);
    Corners spikes = star(3000, 1), spiral;
    for (Vec<3>& p : spikes) p *= random.uniform(0.1, 1);
    for (int i = 0; i < 800; ++i) spiral.push_back((1 + 0.02 * i) * Vec<3>(std::cos(0.2 * i), std::sin(0.2 * i), 0));
    for (int i = 800; i-- > 0;)  // back along a wall that is not smooth
        spiral.push_back((1.1 + 0.02 * i + random.uniform(0, 0.3)) * Vec<3>(std::cos(0.2 * i), std::sin(0.2 * i), 0));
    std::reverse(spiral.begin(), spiral.end());
    for (const Corners& corners : {spikes, spiral}) expect_cut(corners, Vec<3>(0, 0, 1), shoelace(corners) / 2);
}

TEST(CutPolygon, OnesThatCrossThemselvesLoseNothing) {
    Random random(5);
    for (int n = 0; n < 500; ++n) {
        Corners corners(4 + random.below(12));
        for (Vec<3>& p : corners) p = Vec<3>(random.below(6), random.below(6), random.below(6));
        if (n % 7 == 0) corners[1][1] = std::numeric_limits<double>::quiet_NaN();
        if (n % 5 == 0) corners[2] = corners[0];
        EXPECT_EQ(cut_into(corners).size(), corners.size() - 2);
    }
    const Corners pentagram = {Vec<3>(0, 1, 0), Vec<3>(-0.6, -0.8, 0), Vec<3>(0.95, 0.3, 0), Vec<3>(-0.95, 0.3, 0),
                               Vec<3>(0.6, -0.8, 0)};
    EXPECT_EQ(cut_into(pentagram).size(), 3u);
}

TEST(CutPolygon, LargeOnesTakeNoTime) {
    constexpr std::size_t many = 100'000;
    expect_cut(star(many, 1), Vec<3>(0, 0, 1), star_area(many, 1));
    expect_cut(star(many, 0.5), Vec<3>(0, 0, 1), star_area(many, 0.5));
    Random random(5);
    Corners wild(many);
    for (Vec<3>& p : wild) p = Vec<3>(random.uniform(0, 1), random.uniform(0, 1), 0);
    std::vector<Primitive<3>> triangles;
    EXPECT_FALSE(PolygonCutter(0).cut(wild, triangles)) << "it is given up";
}

}  // namespace
}  // namespace sightline
