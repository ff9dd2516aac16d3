// Predicates on inputs next to degenerate, of any size, against exact rationals: predicates [COUNT], status 1 if one
// differs. The same program runs natively and in node.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_rational.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/base/random.h"
#include "core/geometry/crossing.h"
#include "core/geometry/predicates.h"

using namespace sightline;

namespace {

using Rational = CGAL::Exact_rational;

struct Point {
    Rational x, y;
    Point(Rational px, Rational py) : x(std::move(px)), y(std::move(py)) {}
    explicit Point(const Vec<2>& p) : x(p.x), y(p.y) {}
};

int sign(const Rational& value) { return static_cast<int>(CGAL::sign(value)); }

Rational cross_of(const Point& a, const Point& b, const Point& c) {
    return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

Point point_of(const Crossing& c) {
    const Point s0(c.s[0]), s1(c.s[1]), t0(c.t[0]), t1(c.t[1]);
    const Rational d0 = cross_of(t0, t1, s0), d1 = cross_of(t0, t1, s1), part = d0 / (d0 - d1);
    return {s0.x + part * (s1.x - s0.x), s0.y + part * (s1.y - s0.y)};
}

int exact(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
    Rational m[3][3];
    for (int axis = 0; axis < 3; ++axis) {
        m[0][axis] = Rational(a[axis]) - Rational(d[axis]);
        m[1][axis] = Rational(b[axis]) - Rational(d[axis]);
        m[2][axis] = Rational(c[axis]) - Rational(d[axis]);
    }
    return -sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

Vec<2> point(Random& random) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    return {x, y};
}
Vec<3> point_3d(Random& random) {
    const Vec<2> p = point(random);
    const double z = random.uniform(-1, 1);
    return {p.x, p.y, z};
}

}  // namespace

int main(int argc, char** argv) {
    const long count = argc > 1 ? std::atol(argv[1]) : 100'000;
    Random random(11);
    long wrong = 0, zero = 0, crossings = 0;
    for (long i = 0; i < count; ++i) {
        const double scale = std::ldexp(1.0, static_cast<int>(random.below(400)) - 200);
        const Vec<2> a = point(random), b = point(random), c = a + (b - a) * random.uniform(-2, 2);
        const int turn = orient(a * scale, b * scale, c * scale);
        wrong += turn != sign(cross_of(Point(a * scale), Point(b * scale), Point(c * scale)));
        zero += turn == 0;
        if (i % 4 == 0) {
            const Vec<3> p = point_3d(random), q = point_3d(random), r = point_3d(random);
            const double u = random.uniform(-2, 2), v = random.uniform(-2, 2);
            const Vec<3> s = p + (q - p) * u + (r - p) * v;
            wrong +=
                orient(p * scale, q * scale, r * scale, s * scale) != exact(p * scale, q * scale, r * scale, s * scale);
        }
        if (i % 4 == 1) {
            // A crossing, and an eye on the line through it and another point, as far as doubles get there.
            const Crossing crossing{{a, b}, {point(random), point(random)}};
            if (orient(a, b, crossing.t[0]) * orient(a, b, crossing.t[1]) >= 0 ||
                orient(crossing.t[0], crossing.t[1], a) * orient(crossing.t[0], crossing.t[1], b) >= 0)
                continue;
            const Vec<2> eye = point(random), far = eye + (rounded(crossing) - eye) * random.uniform(0.1, 2);
            ++crossings;
            wrong += orient(eye, crossing, far) != sign(cross_of(point_of(crossing), Point(far), Point(eye)));
        }
    }
    std::printf("%ld inputs, %ld of them collinear, %ld with a crossing: %ld wrong\n", count, zero, crossings, wrong);
    return wrong != 0;
}
