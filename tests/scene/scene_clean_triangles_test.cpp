// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "core/base/random.h"
#include "core/scene/clean.h"
#include "tests/scene/scene_support.h"

namespace sightline {
namespace {

using test::expect_input_error;
using Triangles = std::vector<Primitive<3>>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double no_end = std::numeric_limits<double>::infinity();

TEST(CleanTriangles, DropsWhatCannotBeUsedAndKeepsTheOtherSide) {
    const Vec<3> a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(2, 0, 0), e(0, 0, 1), f(0, 0, 2), minus(-0.0, 0, 0);
    Scene<3> scene;
    scene.primitives = {{a, b, c},
                        {c, a, b},
                        {b, a, c},
                        {a, b, d},
                        {a, e, f},
                        {a, a, b},
                        {a, b, e},
                        {b, c, minus},
                        {a, b, Vec<3>(0, no_number, 0)},
                        {Vec<3>(no_end, 0, 0), b, c}};
    clean(scene, Recentre::no, "x");
    EXPECT_EQ(scene.dropped, (Dropped{3, 2, 2}));
    EXPECT_EQ(scene.primitives, (Triangles{{a, b, c}, {b, a, c}, {a, b, e}}));
    EXPECT_TRUE(scene.two_sided.empty());
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(CleanTriangles, RoundsBeforeItTests) {
    // In doubles these are two thin triangles, 1e-9 high and apart; in floats they are flat and equal.
    const Vec<3> a(1, 0, 0), b(2, 0, 0), c(1.5, 0, 0), up(0, 0, 1);
    const Vec<3> tiny(1e-9, 0, 0);
    Scene<3> scene;
    scene.primitives = {{a, b, up}, {a + tiny, b, up}, {a + tiny, a, up}, {a, b, c}};
    clean(scene, Recentre::no, "x");
    EXPECT_EQ(scene.dropped, (Dropped{2, 1, 0}));
    EXPECT_EQ(scene.primitives, (Triangles{{a, b, up}}));
}

TEST(CleanTriangles, SidesStayWithTheirTriangles) {
    const Vec<3> a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1);
    Scene<3> scene;
    scene.primitives = {{a, a, b}, {a, b, c}, {a, b, d}, {b, c, a}, {c, b, a}};
    scene.two_sided = {1, 0, 0, 1, 0};  // the repetition of the second triangle is two-sided
    clean(scene, Recentre::no, "x");
    EXPECT_EQ(scene.primitives.size(), 3u);
    EXPECT_EQ(scene.two_sided, (std::vector<std::uint8_t>{1, 0, 0}));

    scene.two_sided = {0, 0, 0};
    clean(scene, Recentre::no, "x");
    EXPECT_TRUE(scene.two_sided.empty());
}

TEST(CleanTriangles, AgreesWithTheObviousWay) {
    // Few distinct corners make every kind of clash likely.
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        Scene<3> scene;
        for (int i = 0; i < 3000; ++i) {
            const auto p = [&] {
                return Vec<3>(static_cast<double>(random.below(3)), static_cast<double>(random.below(3)),
                              static_cast<double>(random.below(2)));
            };
            scene.primitives.push_back({p(), p(), p()});
            scene.two_sided.push_back(random.below(2) == 1);
        }
        Dropped dropped;
        Triangles kept;
        std::vector<std::uint8_t> sides;
        std::map<std::array<double, 9>, std::size_t> seen;
        for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
            const Primitive<3>& t = scene.primitives[i];
            if (glm::cross(t[1] - t[0], t[2] - t[0]) == Vec<3>(0)) {
                ++dropped.degenerate;
                continue;
            }
            std::array<double, 9> least{};
            for (std::size_t turn = 0; turn < 3; ++turn) {
                std::array<double, 9> flat;
                for (std::size_t k = 0; k < 9; ++k) flat[k] = t[(turn + k / 3) % 3][static_cast<int>(k % 3)];
                if (turn == 0 || flat < least) least = flat;
            }
            const auto found = seen.find(least);
            if (found != seen.end()) {
                ++dropped.duplicate;
                sides[found->second] |= scene.two_sided[i];
                continue;
            }
            seen[least] = kept.size();
            kept.push_back(t);
            sides.push_back(scene.two_sided[i]);
        }
        clean(scene, Recentre::no, "x");
        ASSERT_EQ(scene.primitives, kept);
        ASSERT_EQ(scene.dropped, dropped);
        ASSERT_EQ(scene.two_sided, sides);
    }
}

TEST(CleanTriangles, RecentringKeepsTheDetailThatFloatsWouldLose) {
    Random random(4);
    for (const Vec<3> place : {Vec<3>(8.5e4, 4.5e5, 3), Vec<3>(1e6, -1e6, 1e6), Vec<3>(-7e12, 3, 0)}) {
        const double size = 200;
        Scene<3> scene;
        for (int i = 0; i < 500; ++i) {
            const auto p = [&] {
                return place + size * Vec<3>(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            };
            scene.primitives.push_back({p(), p(), p()});
        }
        scene.start_view = ViewSpec<3>{place, place + Vec<3>(1, 0, 0), 60};
        scene.paths = {{"path", {*scene.start_view}}};
        const Triangles before = scene.primitives;
        clean(scene, Recentre::yes, "x");
        ASSERT_EQ(scene.primitives.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                for (int axis = 0; axis < 3; ++axis) {
                    const double here = scene.primitives[i][c][axis];
                    ASSERT_EQ(here, static_cast<double>(static_cast<float>(here)));
                    // Half a float step at 5 sizes, plus the step of the doubles that went in.
                    ASSERT_LE(std::abs(scene.origin[axis] + here - before[i][c][axis]),
                              5 * 2 * size * 0x1p-24 + std::abs(place[axis]) * 0x1p-52);
                }
        EXPECT_EQ(scene.start_view->eye, place - scene.origin);
        EXPECT_EQ(scene.paths[0].frames[0].eye, place - scene.origin);
    }
}

TEST(CleanTriangles, CoincidentAndHugeTrianglesAreCounted) {
    Scene<3> points;
    points.primitives.assign(1000000, {Vec<3>(5, 5, 5), Vec<3>(5, 5, 5), Vec<3>(5, 5, 5)});
    clean(points, Recentre::yes, "x");
    EXPECT_EQ(points.dropped.degenerate, 1000000u);
    EXPECT_EQ(points.warnings, std::vector<std::string>{"the scene is empty: 0 primitives"});
    EXPECT_TRUE(points.primitives.empty());

    Scene<3> same;
    same.primitives.assign(1000000, {Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)});
    double last = -1;
    bool grows = true;
    clean(same, Recentre::yes, "x", [&](std::string_view, double share) {
        grows = grows && share >= last && share <= 1;
        last = share;
    });
    EXPECT_EQ(same.dropped.duplicate, 999999u);
    EXPECT_TRUE(grows);
    EXPECT_EQ(last, 1);
}

TEST(CleanTriangles, RefusesWhatFloatsCannotSquare) {
    Scene<3> large, tiny;
    large.primitives = {{Vec<3>(0), Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)},
                        {Vec<3>(0), Vec<3>(1, 0, 0), Vec<3>(0, 1e19, 0)}};
    expect_input_error([&] { clean(large, Recentre::no, "x"); },
                       "x: triangle 1: coordinate 1e+19 is too large (limit 1e18)");
    tiny.primitives = {{Vec<3>(0), Vec<3>(0x1p-80, 0, 0), Vec<3>(0, 0x1p-80, 0)}};
    expect_input_error([&] { clean(tiny, Recentre::no, "x"); }, "x: the scene is 8.271*");
}

}  // namespace
}  // namespace sightline
