// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "core/scene/clean.h"
#include "core/scene/view.h"
#include "tests/scene/scene_support.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using test::expect_input_error;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Primitive<2> segment(double x0, double y0, double x1, double y1) { return {Vec<2>(x0, y0), Vec<2>(x1, y1)}; }

TEST(SceneClean, DropsAndCountsWhatCannotBeUsed) {
    Scene<2> scene;
    scene.primitives = {segment(0, 0, 1, 0), segment(1, 0, 0, 0),    segment(2, 2, 2, 2),       segment(0, nan, 1, 1),
                        segment(0, 1, 1, 1), segment(-0.0, 1, 1, 1), segment(3, infinity, 1, 1)};
    clean(scene, Recentre::no, "x");
    EXPECT_EQ(scene.dropped, (Dropped{1, 2, 2}));
    ASSERT_EQ(scene.primitives.size(), 2u);
    EXPECT_EQ(scene.primitives[0], segment(0, 0, 1, 0));
    EXPECT_EQ(scene.primitives[1], segment(0, 1, 1, 1));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneClean, EmptySceneIsFineWithAWarning) {
    Scene<2> scene;
    clean(scene, Recentre::yes, "x");
    EXPECT_EQ(scene.warnings, std::vector<std::string>{"the scene is empty: 0 primitives"});
    EXPECT_EQ(default_view(scene.primitives), (ViewSpec<2>{{0, 0}, {1, 0}, 90}));
}

TEST(SceneClean, RefusesCoordinatesThatOverflowAndScenesThatVanish) {
    Scene<2> large, tiny;
    large.primitives = {segment(0, 0, 1, 1), segment(0, 0, 1e151, 0)};
    expect_input_error([&] { clean(large, Recentre::no, "x"); },
                       "x: segment 1: coordinate 1e+151 is too large (limit 1e150)");
    tiny.primitives = {segment(0, 0, 1e-160, 0)};
    expect_input_error([&] { clean(tiny, Recentre::no, "x"); },
                       "x: the scene is 1e-160 units wide, too small (limit 1e-150)");
}

TEST(SceneClean, RecentringIsExact) {
    Random random(4);
    for (const Vec<2> place : {Vec<2>(1.8e6, 5.2e6), Vec<2>(16.37, 48.2), Vec<2>(8.5e4, 4.5e5), Vec<2>(-7e12, 3)})
        for (const double size : {1e-4, 0.7, 300.0, 5e4}) {
            Scene<2> scene;
            for (int i = 0; i < 200; ++i) {
                const auto p = [&] { return place + size * Vec<2>(random.uniform(-1, 1), random.uniform(-1, 1)); };
                scene.primitives.push_back({p(), p()});
            }
            Scene<2> moved = scene;
            clean(scene, Recentre::no, "x");
            clean(moved, Recentre::yes, "x");
            ASSERT_EQ(moved.primitives.size(), scene.primitives.size());
            const double side = bounds<2>(moved.primitives).longest_side();
            for (std::size_t i = 0; i < scene.primitives.size(); ++i)
                for (int end = 0; end < 2; ++end) {
                    const Vec<2> there = scene.primitives[i][end], here = moved.primitives[i][end];
                    ASSERT_EQ(moved.origin + here, there);
                    // Equality of sums could hide a rounded difference; the other way round it cannot.
                    ASSERT_EQ(there - moved.origin, here);
                    ASSERT_EQ(there - here, moved.origin);
                    ASSERT_LE(std::abs(here.x), 6 * side);
                    ASSERT_LE(std::abs(here.y), 6 * side);
                }
        }
}

TEST(SceneClean, RecentringLeavesSmallCoordinatesAndScalesWithPowersOfTwo) {
    Scene<2> near, far, scaled;
    near.primitives = {segment(0, 0, 100, 50)};
    clean(near, Recentre::yes, "x");
    EXPECT_EQ(near.origin, Vec<2>(0, 0));

    far.primitives = {segment(5000, 10, 5100, 60)};
    clean(far, Recentre::yes, "x");
    EXPECT_EQ(far.origin, Vec<2>(5056, 0));  // 79 times 64
    EXPECT_EQ(far.primitives[0], segment(-56, 10, 44, 60));

    scaled.primitives = {segment(5000 * 1024.0, 10 * 1024.0, 5100 * 1024.0, 60 * 1024.0)};
    clean(scaled, Recentre::yes, "x");
    EXPECT_EQ(scaled.origin, far.origin * 1024.0);
}

TEST(SceneDefaultView, StandsInTheLargestEmptySpotAndLooksAtASegment) {
    // A room of 32 x 32 whose right half is empty.
    std::vector<Primitive<2>> segments = {segment(0, 0, 32, 0), segment(32, 0, 32, 32), segment(32, 32, 0, 32),
                                          segment(0, 32, 0, 0)};
    for (int i = 1; i < 16; i += 2) segments.push_back(segment(i, 1, i, 31));
    const ViewSpec<2> view = default_view(segments);
    EXPECT_GT(view.eye.x, 20);
    EXPECT_LT(view.eye.x, 27);
    EXPECT_EQ(view.look_at, Vec<2>(15, 16));
    EXPECT_EQ(view, default_view(segments));
}

TEST(SceneDefaultView, AlwaysSeesSomething) {
    Random random(9);
    for (int round = 0; round < test::soak_count(300); ++round) {
        const double scale = std::ldexp(1.0, static_cast<int>(random.below(600)) - 300);
        const Vec<2> place = random.below(2) ? Vec<2>(0, 0) : scale * 1e9 * Vec<2>(random.unit(), random.unit());
        const double flat = random.below(3) == 0 ? 0 : 1;
        Scene<2> scene;
        const std::uint64_t count = 1 + random.below(round % 10 == 0 ? 3000 : 5);
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto p = [&] { return place + scale * Vec<2>(random.unit(), flat * random.unit()); };
            scene.primitives.push_back({p(), p()});
        }
        clean(scene, Recentre::no, "x");
        const ViewSpec<2> spec = default_view(scene.primitives);
        check_view(spec, "x", "view");
        const View<2> view = make_view(spec);
        bool seen = false;
        for (const Primitive<2>& s : scene.primitives) seen = seen || in_view(view, s);
        ASSERT_TRUE(seen) << round;
    }
}

TEST(SceneCheckView, RefusesViewsThatSeeNothing) {
    const auto check = [](const ViewSpec<2>& view) { check_view(view, "x", "/view"); };
    check({{0, 0}, {1, 0}, 360});
    check({{0, 0}, {1, 0}, 179});
    expect_input_error([&] { check({{1, 2}, {1, 2}, 60}); }, "x: /view: look_at is the same point as eye");
    expect_input_error(
        [&] {
            check({{nan, 2}, {1, 2}, 60});
        },
        "x: /view: eye and look_at must be numbers of at most 1e150");
    for (const double fov : {0.0, -1.0, 180.0, 361.0})
        expect_input_error([&] { check({{0, 0}, {1, 0}, fov}); }, "x: /view: fov *");
    expect_input_error(
        [&] {
            check_view(ViewSpec<3>{{0, 0, 0}, {1, 0, 0}, 360}, "x", "view");
        },
        "x: view: fov 360 is not between 0 and 180");
}

}  // namespace
}  // namespace sightline
