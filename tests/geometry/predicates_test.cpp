// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/base/trig.h"
#include "core/geometry/predicates.h"
#include "tests/geometry/near_degenerate.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

Exact::Point_2 exact(const Vec<2>& p) { return {p.x, p.y}; }
Exact::Point_3 exact(const Vec<3>& p) { return {p.x, p.y, p.z}; }

int exact_orient(const std::array<Vec<3>, 4>& p) {
    return CGAL::orientation(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]));
}

TEST(Predicates, OrientIsExactOnNearlyCollinearPointsOfAnySize) {
    Random random(1);
    for (int i = 0; i < test::soak_count(20000); ++i) {
        const double scale = std::ldexp(1.0, static_cast<int>(random.below(400)) - 200);
        const Vec<2> a(random.uniform(-1, 1), random.uniform(-1, 1)), b(random.uniform(-1, 1), random.uniform(-1, 1));
        const Vec<2> c = a + (b - a) * random.uniform(-2, 2);
        ASSERT_EQ(orient(a * scale, b * scale, c * scale),
                  CGAL::orientation(exact(a * scale), exact(b * scale), exact(c * scale)));
    }
}

TEST(Predicates, OrientSurvivesUnderflowAndOverflow) {
    EXPECT_EQ(orient(Vec<2>(0, 0), Vec<2>(1e-200, 0), Vec<2>(0, 1e-200)), 1);
    EXPECT_EQ(orient(Vec<2>(0, 0), Vec<2>(1e200, 0), Vec<2>(0, 1e200)), 1);
    EXPECT_EQ(orient(Vec<2>(0, 0), Vec<2>(1e200, 1e200), Vec<2>(1e180, 1e180)), 0);
}

TEST(Predicates, OrientIsExactOnNearlyCoplanarPointsOfAnySize) {
    Random random(3);
    const auto point = [&] { return Vec<3>(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
    const auto grid_point = [&] { return Vec<3>(random.below(3), random.below(3), random.below(3)); };
    int signs[3] = {};
    for (int i = 0; i < test::soak_count(60000); ++i) {
        std::array<Vec<3>, 4> p{point(), point(), point(), point()};
        switch (i % 4) {
            case 1:  // rounded to the plane
                p[3] = p[0] + (p[1] - p[0]) * random.uniform(-2, 2) + (p[2] - p[0]) * random.uniform(-2, 2);
                break;
            case 2:
                for (Vec<3>& q : p) q = grid_point();
                break;
            case 3:  // a thin needle far away
                for (Vec<3>& q : p) q = Vec<3>(1e6, -2e6, 3e6) + q * 1e-6;
        }
        // Each axis has a size of its own: products under- and overflow in some factors and not in others.
        Vec<3> scale(1);
        for (int axis = 0; axis < 3 && i % 8 >= 4; ++axis)
            scale[axis] = std::ldexp(1.0, static_cast<int>(random.below(1800)) - 950);
        for (Vec<3>& q : p) q *= scale;
        const int sign = orient(p[0], p[1], p[2], p[3]);
        ASSERT_EQ(sign, exact_orient(p)) << i;
        ++signs[sign + 1];
    }
    for (const int count : signs) EXPECT_GT(count, 1000);
}

/// The filter's own decisions: where underflow loses whole terms, it must leave the sign to exact arithmetic.
TEST(Predicates, OrientSurvivesUnderflowInSingleFactors) {
    Random random(4);
    for (int i = 0; i < test::soak_count(20000); ++i) {
        std::array<Vec<3>, 4> p;
        for (Vec<3>& q : p)
            for (int axis = 0; axis < 3; ++axis) q[axis] = std::ldexp(random.uniform(-4, 4), axis < 2 ? -537 : 900);
        ASSERT_EQ(orient(p[0], p[1], p[2], p[3]), exact_orient(p)) << i;
    }
    EXPECT_EQ(orient(Vec<3>(0), Vec<3>(1e200, 0, 0), Vec<3>(0, 1e200, 0), Vec<3>(0, 0, 1e200)), 1);
    EXPECT_EQ(orient(Vec<3>(0), Vec<3>(1e-200, 0, 0), Vec<3>(0, 1e-200, 0), Vec<3>(0, 0, -1e-200)), -1);
}

/// web/tests/predicates.cpp tries the same in WebAssembly, where rounding and large numbers are others.
TEST(Predicates, AgreeWithRationalsWhereInputsAreNextToDegenerate) {
    const auto found = test::try_near_degenerate(test::soak_count(50'000));
    EXPECT_EQ(found.wrong, 0);
    EXPECT_EQ(found.rounded, 0);
    EXPECT_GT(found.collinear, found.inputs / 100);
    EXPECT_GT(found.coplanar, found.inputs / 1000);
    EXPECT_GT(found.crossings, found.inputs / 100);
}

TEST(Rational, AreRoundedToTheNearestDouble) {
    Random random(12);
    const Rational tiny = to_rational(0x1p-1074);
    EXPECT_EQ(to_nearest(tiny), 0x1p-1074);
    EXPECT_EQ(to_nearest(tiny / 2), 0) << "of two the even one";
    EXPECT_EQ(to_nearest(tiny * 3 / 2), 0x1p-1073);
    EXPECT_EQ(to_nearest(-tiny * 2 / 3), -0x1p-1074);
    EXPECT_EQ(to_nearest(to_rational(0x1p1000) * to_rational(0x1p1000)), 0x1.fffffffffffffp1023);
    for (int i = 0; i < test::soak_count(2000); ++i) {
        const double value = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(2000)) - 1060);
        const double next = std::nextafter(value, 1e300);
        ASSERT_EQ(to_nearest(to_rational(value)), value);
        const Rational middle = (to_rational(value) + to_rational(next)) / 2,
                       bit = (middle - to_rational(value)) / 1024;
        ASSERT_EQ(to_nearest(middle - bit), value);
        ASSERT_EQ(to_nearest(middle + bit), next);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(to_nearest(middle)) & 1, 0u);
    }
}

TEST(Predicates, SegmentsMeetAgreesWithExactIntersection) {
    Random random(2);
    const auto grid_point = [&] { return Vec<2>(random.below(5), random.below(5)); };
    for (int i = 0; i < test::soak_count(20000); ++i) {
        const Vec<2> a = grid_point(), b = grid_point(), c = grid_point(), d = grid_point();
        if (a == b || c == d) continue;
        ASSERT_EQ(segments_meet(a, b, c, d),
                  CGAL::do_intersect(Exact::Segment_2(exact(a), exact(b)), Exact::Segment_2(exact(c), exact(d))));
    }
}

TEST(Trig, AgreesWithTheCLibraryAndIsExactAtRightAngles) {
    for (int i = -7200; i <= 7200; ++i) {
        const double degrees = i / 10.0;
        EXPECT_NEAR(sincos_degrees(degrees).sin, std::sin(degrees * pi / 180), 2e-14);
        EXPECT_NEAR(sincos_degrees(degrees).cos, std::cos(degrees * pi / 180), 2e-14);
        const double y = std::sin(degrees), x = std::cos(degrees);
        EXPECT_NEAR(angle_of(y, x), std::atan2(y, x), 2e-15);
    }
    EXPECT_EQ(sincos_degrees(90).cos, 0);
    EXPECT_EQ(sincos_degrees(180).sin, 0);
}

}  // namespace
}  // namespace sightline
