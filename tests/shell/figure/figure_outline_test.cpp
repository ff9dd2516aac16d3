// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "shell/figure/outline.h"

namespace sightline {
namespace {

double area(const std::vector<Vec<2>>& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return sum / 2;
}

double length(const Path& path) {
    double sum = 0;
    std::size_t begin = 0;
    for (const std::uint32_t end : path.ends) {
        for (std::size_t i = begin; i + 1 < end; ++i) sum += glm::length(path.points[i + 1] - path.points[i]);
        begin = end;
    }
    return sum;
}

const std::vector<Vec<2>> l_shape{{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 30}, {0, 30}};

TEST(FigureOutline, ClippedPolygonsKeepTheAreaInside) {
    const Rect rect{2, 3, 15, 14};
    // 15 by 7 below y = 10 and 8 by 7 above it.
    EXPECT_NEAR(area(clip_polygon(l_shape, rect)), 15 * 7 + 8 * 7, 1e-9);
    EXPECT_TRUE(clip_polygon(l_shape, {40, 40, 5, 5}).empty());
    EXPECT_NEAR(area(clip_polygon(std::vector<Vec<2>>{{-1e12, -1e12}, {1e12, -1e12}, {0, 1e12}}, rect)),
                rect.w * rect.h, 1e-3);
}

TEST(FigureOutline, ClippedPolylinesFallIntoTheirPartsInside) {
    const std::vector<Vec<2>> line{{-5, 5}, {15, 5}, {15, 8}, {-5, 8}, {-5, 20}};
    const Path path = clip_polyline(line, {0, 0, 10, 10});
    ASSERT_EQ(path.ends.size(), 2u);
    EXPECT_NEAR(length(path), 20, 1e-9);
    for (const Vec<2>& p : path.points) EXPECT_TRUE((Rect{0, 0, 10, 10}.grown(1e-9).contains(p)));
    EXPECT_EQ(clip_polyline(std::vector<Vec<2>>{{1, 1}, {2, 2}, {3, 1}}, {0, 0, 10, 10}).points.size(), 3u);
}

TEST(FigureOutline, HatchesLieInsideOnOneGrid) {
    const double pitch = 3;
    for (const Hatch hatch : {Hatch::diagonal, Hatch::back_diagonal, Hatch::cross, Hatch::horizontal}) {
        const Path path = hatch_lines(l_shape, hatch, pitch);
        // Lines of one direction cover about area / pitch.
        const double families = hatch == Hatch::cross ? 2 : 1;
        EXPECT_NEAR(length(path), families * 500 / pitch, 25 * families);
        for (std::size_t i = 0; i < path.points.size(); i += 2) {
            const Vec<2> a = path.points[i], b = path.points[i + 1], m = (a + b) * 0.5;
            EXPECT_TRUE((m.x >= 0 && m.y >= 0 && m.x < 30 && m.y < 30) && (m.x < 10 || m.y < 10));
            const Vec<2> along = glm::normalize(b - a);
            const double offset = cross(along, a) / pitch;
            EXPECT_NEAR(offset, std::round(offset), 1e-9);
        }
    }
}

TEST(FigureOutline, HatchesOfNeighboursMeet) {
    // A square and its two halves along a crooked border have the same hatch.
    const std::vector<Vec<2>> whole{{0, 0}, {40, 0}, {40, 40}, {0, 40}};
    const std::vector<Vec<2>> left{{0, 0}, {17, 0}, {23.5, 40}, {0, 40}}, right{{17, 0}, {40, 0}, {40, 40}, {23.5, 40}};
    for (const Hatch hatch : {Hatch::diagonal, Hatch::cross, Hatch::horizontal}) {
        EXPECT_NEAR(length(hatch_lines(whole, hatch, 2.7)),
                    length(hatch_lines(left, hatch, 2.7)) + length(hatch_lines(right, hatch, 2.7)), 1e-6);
    }
    const std::size_t dots = hatch_lines(whole, Hatch::dots, 2.7).ends.size();
    EXPECT_EQ(dots, hatch_lines(left, Hatch::dots, 2.7).ends.size() + hatch_lines(right, Hatch::dots, 2.7).ends.size());
    EXPECT_GT(dots, 200u);
}

TEST(FigureOutline, HatchesDoNotDependOnOrientationAndFollowTheWinding) {
    std::vector<Vec<2>> reversed(l_shape.rbegin(), l_shape.rend());
    EXPECT_NEAR(length(hatch_lines(l_shape, Hatch::diagonal, 2)), length(hatch_lines(reversed, Hatch::diagonal, 2)),
                1e-9);
    // The middle of a pentagram is wound twice and belongs to it.
    std::vector<Vec<2>> star;
    for (int i = 0; i < 5; ++i)
        star.push_back({50 + 40 * std::sin(i * 2.51327412), 50 - 40 * std::cos(i * 2.51327412)});
    bool middle = false;
    const Path path = hatch_lines(star, Hatch::horizontal, 2);
    for (std::size_t i = 0; i < path.points.size(); i += 2)
        middle |= path.points[i].y == 50 && path.points[i].x < 50 && path.points[i + 1].x > 50;
    EXPECT_TRUE(middle);
}

}  // namespace
}  // namespace sightline
