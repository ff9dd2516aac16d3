// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/run/method.h"
#include "tests/scene/random_scene.h"
#include "tests/soak.h"

namespace sightline {
namespace {

/// The exact form of in_view(): every corner strictly beyond one plane of the cone.
bool beyond_a_plane(const View<3>& view, std::span<const Vec<3>> corners) {
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec<3>&a = view.corners[i], &b = view.corners[(i + 1) % 4];
        const int inside = orient(view.eye, a, b, view.look_at);
        if (std::all_of(corners.begin(), corners.end(),
                        [&](const Vec<3>& p) { return orient(view.eye, a, b, p) == -inside; }))
            return true;
    }
    return false;
}

ViewSpec<3> random_spec(Random& random) {
    const auto coordinate = [&] {
        return random.below(3) ? random.uniform(-1, 2) : std::floor(random.uniform(0, 9)) / 8;
    };
    ViewSpec<3> spec{{coordinate(), coordinate(), coordinate()}, {0.5, 0.5, 0.5}, random.uniform(1, 150)};
    if (spec.eye == spec.look_at) spec.look_at.x += 1;
    return spec;
}

TEST(View3, InViewIsNeverFalseForWhatTheConeMeetsAndSeldomTrueForOthers) {
    Random random(41);
    std::size_t outside = 0, kept = 0;
    for (int i = 0; i < test::soak_count(200); ++i) {
        const double scale = i % 4 == 3 ? std::ldexp(1.0, static_cast<int>(random.below(960)) - 480) : 1;
        ViewSpec<3> spec = random_spec(random);
        spec.eye *= scale;
        spec.look_at *= scale;
        const View<3> view = make_view(spec, random.uniform(0.3, 3));
        for (Primitive<3> t : test::random_scene_3d(random, 100).primitives) {
            for (Vec<3>& p : t) p *= scale;
            const bool beyond = beyond_a_plane(view, t);
            if (beyond) {
                ++outside;
                kept += scale == 1 && in_view(view, t);
            } else {
                ASSERT_TRUE(in_view(view, t));
            }
        }
    }
    EXPECT_GT(outside, 2500u);
    EXPECT_EQ(kept, 0u);
}

TEST(View3, ThatOverflowsIsRefused) {
    const ViewSpec<3> near{{1e140, 0, 0}, {0, 0, 0}, 60}, far{{1e160, 0, 0}, {0, 0, 0}, 60};
    EXPECT_NO_THROW(make_view(near, 1));
    EXPECT_THROW(make_view(far, 1), InputError);
}

TEST(View3, WhatTouchesTheBorderOfTheConeIsInView) {
    Random random(42);
    for (int i = 0; i < test::soak_count(2000); ++i) {
        const View<3> view = make_view(random_spec(random), random.uniform(0.3, 3));
        for (std::size_t side = 0; side < 4; ++side) {
            const Vec<3> a = view.corners[side], b = view.corners[(side + 1) % 4];
            const Vec<3> outwards = (a + b) * 0.5 + ((a + b) * 0.5 - view.look_at) * random.uniform(0.01, 5);
            // A corner of the triangle is a corner of the cone, bit for bit; the others lie outside.
            ASSERT_TRUE(in_view(view, Primitive<3>{a, outwards, outwards + (a - b) * 0.1}));
            ASSERT_FALSE(
                in_view(view, Primitive<3>{outwards, outwards + (a - b) * 0.1, outwards + (outwards - a) * 0.1}));
        }
    }
}

TEST(View3, ATriangleFacesTheEyeThatSeesItTurnCounterClockwise) {
    const View<3> above = make_view(ViewSpec<3>{{0.2, 0.2, 3}, {0.2, 0.2, 0}, 60}, 1);
    const Primitive<3> up{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)};
    const Primitive<3> down{up[0], up[2], up[1]};
    EXPECT_TRUE(faces(above, up));
    EXPECT_FALSE(faces(above, down));
    const View<3> below = make_view(ViewSpec<3>{{0.2, 0.2, -3}, {0.2, 0.2, 0}, 60}, 1);
    EXPECT_FALSE(faces(below, up));
    EXPECT_TRUE(faces(below, down));
    const View<3> beside = make_view(ViewSpec<3>{{3, 0.2, 0}, {0.2, 0.2, 0}, 60}, 1);
    EXPECT_FALSE(faces(beside, up));
    EXPECT_FALSE(faces(beside, down));
}

TEST(View3, OneSidedTrianglesAreShownFromTheirFrontTwoSidedOnesFromBothSides) {
    const std::vector<Primitive<3>> triangles{{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)},
                                              {Vec<3>(0, 0, 0), Vec<3>(0, 1, 0), Vec<3>(1, 0, 0)}};
    Scene<3> plain, second_two_sided;
    plain.primitives = second_two_sided.primitives = triangles;
    second_two_sided.two_sided = {0, 1};
    const CellComplex<3> cells;
    for (const double z : {3.0, -3.0}) {
        const View<3> view = make_view(ViewSpec<3>{{0.2, 0.2, z}, {0.2, 0.2, 0}, 60}, 1);
        const Problem<3> one_sided = make_problem<3>({}, {}, plain, cells, view);
        EXPECT_EQ(shows(one_sided, 0), z > 0);
        EXPECT_EQ(shows(one_sided, 1), z < 0);
        const Problem<3> mixed = make_problem<3>({}, {}, second_two_sided, cells, view);
        EXPECT_EQ(shows(mixed, 0), z > 0);
        EXPECT_TRUE(shows(mixed, 1));
    }
}

}  // namespace
}  // namespace sightline
