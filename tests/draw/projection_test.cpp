// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/projection.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace sightline {
namespace {

Vec<3> random_point(Random& random, double reach) {
    return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

View<3> random_view3(Random& random) {
    const double reach = random.below(2) == 0 ? 1 : 1e4;
    return make_view({random_point(random, reach), random_point(random, reach), random.uniform(5, 150)},
                     random.uniform(0.3, 4), random.below(2) == 0 ? 1 : 2);
}

TEST(Projection, CornersOfTheViewAreThoseOfThePicture) {
    Random random(311);
    for (int i = 0; i < 300; ++i) {
        const View<3> view = random_view3(random);
        const Box<2> plane = picture_plane(view);
        ASSERT_EQ(plane.min, Vec<2>(0, 0));
        ASSERT_EQ(plane.max.y, 1);
        const double far = random.uniform(0.1, 50);  // at any depth
        const std::array<Vec<2>, 4> corners{plane.min, {plane.max.x, 0}, plane.max, {0, 1}};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto at = project(view, view.eye + (view.corners[k] - view.eye) * far);
            ASSERT_TRUE(at);
            ASSERT_NEAR(glm::length(*at - corners[k]), 0, 1e-9 * plane.max.x + 1e-9);
        }
        ASSERT_NEAR(glm::length(*project(view, view.look_at) - plane.centre()), 0, 1e-9);
        ASSERT_NEAR(depth(view, view.look_at), 1, 1e-12);
    }
}

TEST(Projection, IsWhereTheRayThroughThePointMeetsThePicture) {
    Random random(312);
    for (int i = 0; i < 2000; ++i) {
        const View<3> view = random_view3(random);
        const Box<2> plane = picture_plane(view);
        const Vec<3> right = view.corners[1] - view.corners[0], up = view.corners[3] - view.corners[0];
        const Vec<2> asked(random.uniform(-2, 3), random.uniform(-2, 3));
        const Vec<3> on_plane = view.corners[0] + right * (asked.x / plane.max.x) + up * asked.y;
        const auto at = project(view, view.eye + (on_plane - view.eye) * random.uniform(0.001, 100));
        ASSERT_TRUE(at);
        ASSERT_NEAR(glm::length(*at - asked), 0, 1e-7);
        ASSERT_FALSE(project(view, view.eye - (on_plane - view.eye) * random.uniform(0, 100)));
        // A picture of the same view: what lies in it is in view, what lies beside it is not.
        const bool inside = plane.contains(asked);
        const std::array<Vec<3>, 1> point{on_plane};
        if (std::abs(asked.x) > 1e-6 && std::abs(asked.x - plane.max.x) > 1e-6 && std::abs(asked.y) > 1e-6 &&
            std::abs(asked.y - 1) > 1e-6) {
            ASSERT_EQ(in_view(view, point), inside);
        }
    }
    EXPECT_FALSE(project(make_view({{0, 0, 0}, {1, 0, 0}, 60}, 1), {0, 0, 0}));
    EXPECT_FALSE(project(make_view({{0, 0, 0}, {1, 0, 0}, 60}, 1), {0, 1, 0}));
}

TEST(Projection, LinesAreCutBeforeTheEyeAndBesideThePicture) {
    Random random(313);
    int cut = 0, whole = 0, gone = 0;
    for (int i = 0; i < 3000; ++i) {
        const View<3> view = random_view3(random);
        const Box<2> plane = picture_plane(view);
        const double size = glm::length(view.look_at - view.eye);
        const Vec<3> a = view.eye + random_point(random, 3) * size, b = view.eye + random_point(random, 3) * size;
        const auto line = project_line(view, a, b);
        const auto before = [&](const Vec<3>& p) { return depth(view, p) > 1e-5; };
        if (line)
            for (const Vec<2>& p : {line->a, line->b}) {
                ASSERT_TRUE(is_finite(p));
                ASSERT_GE(std::min(p.x, p.y), -0.5 - 1e-6);
                ASSERT_LE(p.x, plane.max.x + 0.5 + 1e-6);
                ASSERT_LE(p.y, 1.5 + 1e-6);
            }
        // Every point of the line that the picture shows lies on what is left of it.
        bool seen = false;
        for (int k = 0; k <= 40; ++k) {
            const Vec<3> p = a + (b - a) * (k / 40.0);
            const auto at = before(p) ? project(view, p) : std::nullopt;
            if (!at || !plane.contains(*at)) continue;
            seen = true;
            ASSERT_TRUE(line);
            const Vec<2> along = line->b - line->a;
            const double length2 = glm::dot(along, along);
            const double t = length2 > 0 ? glm::dot(*at - line->a, along) / length2 : 0;
            ASSERT_TRUE(t > -1e-6 && t < 1 + 1e-6);
            ASSERT_NEAR(glm::length(line->a + along * t - *at), 0, 1e-6);
        }
        if (!before(a) && !before(b)) {
            ASSERT_FALSE(line && seen);
        }
        if (!line) {
            ++gone;
            continue;
        }
        const auto end = before(b) ? project(view, b) : std::nullopt;
        if (line->to_the_end) {
            ++whole;
            ASSERT_TRUE(end);
            ASSERT_NEAR(glm::length(*end - line->b), 0, 1e-6);
        } else {
            ++cut;
            ASSERT_TRUE(!end || !plane.contains(*end));
        }
    }
    EXPECT_GT(cut, 100);
    EXPECT_GT(whole, 100);
    EXPECT_GT(gone, 100);
}

}  // namespace
}  // namespace sightline
