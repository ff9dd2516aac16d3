// Triangles in floats: what they say for sure of a view is what the exact tests say.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/cell_triangles.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "tests/scene/soup_scenes.h"
#include "tests/soak.h"

namespace sightline::test {
namespace {

Scene<3> moved_soup(int seed, Random& random, double scale, const Vec<3>& away) {
    Scene<3> scene = seed % 2 ? soup(300, {0, 0, 0}, 1, random.bits()) : slivers(300, random.bits());
    if (seed % 4 == 0) scene.two_sided.clear();
    for (auto& triangle : scene.primitives)
        for (auto& corner : triangle) corner = corner * scale + away;
    return scene;
}

TEST(CellTriangles, SayForSureOnlyWhatIsSo) {
    std::array<std::size_t, 3> said{};
    for (int seed = 1; seed <= soak_count(40); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const double scale = std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
        const Vec<3> away = around(random, {0, 0, 0}, random.below(2) ? 1000 : 0) * scale;
        const Scene<3> scene = moved_soup(seed, random, scale, away);
        std::vector<std::uint32_t> references(scene.primitives.size());
        std::iota(references.rbegin(), references.rend(), 0u);
        const CellTriangles triangles(scene, references);
        for (int k = 0; k < 20; ++k) {
            // Also eyes in the plane of a triangle, or a hair beside it, and corners at the border of the view.
            const auto& close = scene.primitives[random.below(scene.primitives.size())];
            const Vec<3> in_plane = close[0] + (close[1] - close[0]) * random.uniform(-2, 2) +
                                    (close[2] - close[0]) * random.uniform(-2, 2);
            ViewSpec<3> spec;
            spec.eye = k % 2 ? in_plane : away + around(random, {0, 0, 0}, 3) * scale;
            spec.look_at = away + around(random, {0, 0, 0}, 1) * scale;
            spec.fov = random.uniform(5, 120);
            View<3> view = make_view(spec, 4.0 / 3);
            if (k % 3 == 0) {
                const auto& at_border = scene.primitives[random.below(scene.primitives.size())];
                if (at_border[0] == spec.eye) continue;
                spec.look_at = at_border[0];
                spec.fov = 1e-3;  // and all that lies ahead at its borders
                view = make_view(spec, 4.0 / 3);
            }
            const ShownFilter filter(view, triangles);
            for (std::size_t i = 0; i < references.size(); ++i) {
                const std::uint32_t id = references[i];
                ASSERT_EQ(triangles.rows()[i].primitive(), id);
                ASSERT_EQ(triangles.rows()[i].two_sided(), shows_both_sides(scene, id));
                const auto& t = scene.primitives[id];
                const bool shows = (shows_both_sides(scene, id) || faces(view, t)) && in_view(view, t);
                const Showing shown = filter.of(triangles.rows()[i]);
                ++said[static_cast<std::size_t>(shown)];
                if (shown != Showing::unsure) {
                    ASSERT_EQ(shown == Showing::yes, shows) << seed << ' ' << id;
                }
            }
        }
    }
    EXPECT_GT(said[0], 20'000u);
    EXPECT_GT(said[1], 100u);
    EXPECT_GT(said[2], 2'000u);
    EXPECT_LT(said[1], (said[0] + said[2]) / 2) << "hardly anything is sure";
}

TEST(CellTriangles, SayNothingForSureOutsideTheRangeOfFloats) {
    for (const double scale : {0x1p-300, 0x1p-110, 0x1p70, 0x1p300}) {
        Random random(3);
        const Scene<3> scene = moved_soup(1, random, scale, Vec<3>(0));
        std::vector<std::uint32_t> references(scene.primitives.size());
        std::iota(references.begin(), references.end(), 0u);
        const CellTriangles triangles(scene, references);
        ViewSpec<3> spec;
        spec.eye = Vec<3>(3, 0.1, 0.2) * scale;
        spec.look_at = Vec<3>(0);
        const ShownFilter filter(make_view(spec, 1), triangles);
        for (const CellTriangle& row : triangles.rows()) ASSERT_EQ(filter.of(row), Showing::unsure);
    }
}

TEST(CellTriangles, HoldsCentroidAndAreaOfTheSideThatIsSeen) {
    Scene<3> scene;
    scene.primitives = {{Vec<3>(10, 0, 0), Vec<3>(13, 0, 0), Vec<3>(10, 3, 0)},
                        {Vec<3>(0, 0, 8), Vec<3>(0, 0, 8) + Vec<3>(1, 0, 0), Vec<3>(2, 1e-9, 8)}};
    const std::vector<std::uint32_t> references{1, 0, 0};
    const CellTriangles triangles(scene, references);
    ASSERT_EQ(triangles.rows().size(), 3u);
    EXPECT_EQ(triangles.rows()[0].area, (std::array<float, 3>{0, 0, 0})) << "a needle";
    for (const std::size_t i : {1, 2}) {
        const CellTriangle& row = triangles.rows()[i];
        EXPECT_EQ(row.area, (std::array<float, 3>{0, 0, 4.5f}));
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(row.centroid[static_cast<std::size_t>(axis)] + triangles.origin()[axis], Vec<3>(11, 1, 0)[axis],
                        1e-5);
        EXPECT_NEAR(row.radius, std::sqrt(5.0), 1e-5);
        EXPECT_GE(row.radius, std::sqrt(5.0));
    }
}

}  // namespace
}  // namespace sightline::test
