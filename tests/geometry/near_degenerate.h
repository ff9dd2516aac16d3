// Predicates against exact rationals, on inputs next to degenerate of any size. The same natively and in WebAssembly.
// Pulls in CGAL, so only .cpp files include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/base/random.h"
#include "core/geometry/crossing.h"
#include "core/geometry/predicates.h"
#include "core/geometry/rational.h"

namespace sightline::test {

struct NearDegenerate {
    long inputs = 0, collinear = 0, coplanar = 0, crossings = 0;
    long wrong = 0;    ///< signs that are not those of rationals
    long rounded = 0;  ///< rationals that are not rounded to the nearest double
};

namespace detail {

struct ExactPoint {
    Rational x, y;
    ExactPoint(Rational px, Rational py) : x(std::move(px)), y(std::move(py)) {}
    explicit ExactPoint(const Vec<2>& p) : x(to_rational(p.x)), y(to_rational(p.y)) {}
};

inline int sign(const Rational& value) { return static_cast<int>(CGAL::sign(value)); }

inline Rational cross_of(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
    return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

inline ExactPoint point_of(const Crossing& c) {
    const ExactPoint s0(c.s[0]), s1(c.s[1]), t0(c.t[0]), t1(c.t[1]);
    const Rational d0 = cross_of(t0, t1, s0), d1 = cross_of(t0, t1, s1), part = d0 / (d0 - d1);
    return {s0.x + part * (s1.x - s0.x), s0.y + part * (s1.y - s0.y)};
}

inline int exact_side(const std::array<Vec<3>, 4>& p) {
    std::array<std::array<Rational, 3>, 3> m;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            m[i][axis] = to_rational(p[i][static_cast<int>(axis)]) - to_rational(p[3][static_cast<int>(axis)]);
    return -sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

/// No double is nearer, and of two that are as near it has the last bit 0.
inline bool is_nearest(const Rational& value, double rounded) {
    const Rational error = CGAL::abs(value - to_rational(rounded));
    for (const double other : {std::nextafter(rounded, -INFINITY), std::nextafter(rounded, INFINITY)}) {
        if (!std::isfinite(other)) continue;
        const Rational apart = CGAL::abs(value - to_rational(other));
        if (apart < error || (apart == error && (std::bit_cast<std::uint64_t>(rounded) & 1))) return false;
    }
    return true;
}

/// Numbers of some 53 bits, or of a few: what is made of those is often degenerate to the last bit.
class Numbers {
public:
    Numbers(Random& random, bool few) : random_(random), few_(few) {}
    double operator()(double most) {
        const double value = random_.uniform(-most, most);
        return few_ ? std::nearbyint(value * 8) / 8 : value;
    }
    Vec<2> point() {
        const double x = (*this)(1), y = (*this)(1);
        return {x, y};
    }
    Vec<3> point_3d() {
        const Vec<2> p = point();
        const double z = (*this)(1);
        return {p.x, p.y, z};
    }

private:
    Random& random_;
    bool few_;
};

}  // namespace detail

/// `count` inputs: three points of about one line each, of four points of about one plane one in four, and crossings
/// with an eye on about the line through them and another point, one in four. One in 16 is of any size between the
/// smallest doubles and 2^200, which takes rationals of a thousand digits.
inline NearDegenerate try_near_degenerate(long count) {
    using namespace detail;
    Random random(11);
    NearDegenerate found;
    for (; found.inputs < count; ++found.inputs) {
        const int power = random.below(16) > 0 ? static_cast<int>(random.below(100)) - 50
                                               : static_cast<int>(random.below(1240)) - 1040;
        const double scale = std::ldexp(1.0, power);
        Numbers number(random, found.inputs % 8 < 2);
        const Vec<2> a = number.point(), b = number.point(), c = a + (b - a) * number(2);
        const std::array<Vec<2>, 3> scaled{a * scale, b * scale, c * scale};
        const int turn = orient(scaled[0], scaled[1], scaled[2]);
        found.wrong += turn != sign(cross_of(ExactPoint(scaled[0]), ExactPoint(scaled[1]), ExactPoint(scaled[2])));
        found.collinear += turn == 0;
        if (found.inputs % 4 == 0) {
            const Vec<3> p = number.point_3d(), q = number.point_3d(), r = number.point_3d();
            const double u = number(2), v = number(2);
            const Vec<3> s = p + (q - p) * u + (r - p) * v;
            const std::array<Vec<3>, 4> four{p * scale, q * scale, r * scale, s * scale};
            const int side = orient(four[0], four[1], four[2], four[3]);
            found.wrong += side != exact_side(four);
            found.coplanar += side == 0;
        }
        if (found.inputs % 4 == 1) {
            const Crossing crossing{{a, b}, {number.point(), number.point()}};
            if (orient(a, b, crossing.t[0]) * orient(a, b, crossing.t[1]) >= 0 ||
                orient(crossing.t[0], crossing.t[1], a) * orient(crossing.t[0], crossing.t[1], b) >= 0)
                continue;
            const Vec<2> eye = number.point(), far = eye + (rounded(crossing) - eye) * random.uniform(0.1, 2);
            const ExactPoint meet = point_of(crossing);
            ++found.crossings;
            found.wrong += orient(eye, crossing, far) != sign(cross_of(meet, ExactPoint(far), ExactPoint(eye)));
            const Rational small =
                meet.x * to_rational(scale) * to_rational(scale);  // down to where doubles lose digits
            found.rounded += !is_nearest(meet.x, to_nearest(meet.x)) + !is_nearest(small, to_nearest(small));
        }
    }
    return found;
}

}  // namespace sightline::test
