// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/crossing.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/geometry/predicates.h"
#include "tests/soak.h"

namespace sightline {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

Exact::Point_2 exact_point(const Vec<2>& p) { return {p.x, p.y}; }

Exact::Point_2 exact_point(const Crossing& p) {
    const auto meet = CGAL::intersection(Exact::Line_2(exact_point(p.s[0]), exact_point(p.s[1])),
                                         Exact::Line_2(exact_point(p.t[0]), exact_point(p.t[1])));
    return *boost::get<Exact::Point_2>(&*meet);
}

bool crosses_properly(const Segment& s, const Segment& t) {
    return orient(s[0], s[1], t[0]) * orient(s[0], s[1], t[1]) < 0 &&
           orient(t[0], t[1], s[0]) * orient(t[0], t[1], s[1]) < 0;
}

/// Small integers, where three lines often meet in one point, or doubles with an offset.
Crossing random_crossing(Random& random, bool integers) {
    const auto point = [&]() -> Vec<2> {
        if (integers) return {random.below(8), random.below(8)};
        return Vec<2>(1e3 + random.uniform(-1, 1), random.uniform(-1, 1));
    };
    for (;;) {
        const Crossing p{{point(), point()}, {point(), point()}};
        if (crosses_properly(p.s, p.t)) return p;
    }
}

TEST(Crossing, OrientIsThatOfTheRealPoint) {
    Random random(1);
    int zeros = 0;
    for (int i = 0; i < test::soak_count(6000); ++i) {
        const bool integers = i % 2 == 0;
        const Crossing p = random_crossing(random, integers), q = random_crossing(random, integers);
        const Vec<2> eye = random_crossing(random, integers).s[0], r = q.t[0];
        const int with_point = CGAL::orientation(exact_point(eye), exact_point(p), exact_point(r));
        const int with_crossing = CGAL::orientation(exact_point(eye), exact_point(p), exact_point(q));
        ASSERT_EQ(orient(eye, p, r), with_point);
        ASSERT_EQ(orient(eye, p, q), with_crossing);
        zeros += (with_point == 0) + (with_crossing == 0);
    }
    EXPECT_GT(zeros, 50);
}

TEST(Crossing, OrientTellsThePointsBesideTheRoundedCrossingApart) {
    Random random(2);
    for (int i = 0; i < test::soak_count(3000); ++i) {
        const Crossing p = random_crossing(random, false);
        const Vec<2> eye(random.uniform(-1, 1), random.uniform(-1, 1));
        Vec<2> near = rounded(p);
        for (int step = 0; step < 4; ++step) {
            ASSERT_EQ(orient(eye, p, near), CGAL::orientation(exact_point(eye), exact_point(p), exact_point(near)));
            near.y = std::nextafter(near.y, 2);
        }
    }
}

TEST(Crossing, RoundedPointsAreWithinTheirBound) {
    Random random(3);
    const auto largest = [](const Segment& s) {
        return std::max({std::abs(s[0].x), std::abs(s[0].y), std::abs(s[1].x), std::abs(s[1].y)});
    };
    const auto expect_near = [&](const Vec<2>& p, const Exact::Point_2& q, const Segment& s) {
        const double bound = 1e-14 * largest(s);
        ASSERT_LE(CGAL::to_double(CGAL::abs(Exact::FT(p.x) - q.x())), bound);
        ASSERT_LE(CGAL::to_double(CGAL::abs(Exact::FT(p.y) - q.y())), bound);
    };
    for (int i = 0; i < test::soak_count(3000); ++i) {
        const Segment s = random_crossing(random, i % 2 == 0).s;
        // A second segment that is all but parallel to the first: the worst case.
        const double tilt = random.uniform(-1, 1) * (i % 3 == 0 ? 1 : 1e-9);
        const Vec<2> shift = Vec<2>(s[0].y - s[1].y, s[1].x - s[0].x) * tilt;
        const Segment t{s[0] + shift, s[1] - shift * random.unit()};
        if (!crosses_properly(s, t)) continue;
        ASSERT_NO_FATAL_FAILURE(expect_near(rounded({s, t}), exact_point(Crossing{s, t}), s));
        ASSERT_NO_FATAL_FAILURE(expect_near(hit(s, t[0], t[1]), exact_point(Crossing{s, t}), s));
    }
}

TEST(Crossing, HitTowardsACrossing) {
    const Segment wall{Vec<2>(4, -4), Vec<2>(4, 4)};
    const Crossing p{{Vec<2>(1, 0), Vec<2>(3, 2)}, {Vec<2>(1, 2), Vec<2>(3, 0)}};  // at (2, 1)
    EXPECT_EQ(rounded(p), Vec<2>(2, 1));
    EXPECT_EQ(hit(wall, {0, 0}, p), Vec<2>(4, 2));
    EXPECT_EQ(hit(wall, {0, 0}, Vec<2>(2, 1)), Vec<2>(4, 2));
}

}  // namespace
}  // namespace sightline
