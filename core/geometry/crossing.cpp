// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/crossing.h"

#include <CGAL/Interval_nt.h>

#include "core/geometry/predicates.h"
#include "core/geometry/rational.h"

namespace sightline {

namespace {

using Interval = CGAL::Interval_nt<false>;

template <typename T>
struct Vector {
    T x, y;
};

template <typename T>
T number(double value) {
    if constexpr (std::is_same_v<T, Rational>)
        return to_rational(value);
    else
        return T(value);
}

template <typename T>
Vector<T> difference(const Vec<2>& head, const Vec<2>& tail) {
    return {number<T>(head.x) - number<T>(tail.x), number<T>(head.y) - number<T>(tail.y)};
}

template <typename T>
T cross_of(const Vector<T>& a, const Vector<T>& b) {
    return a.x * b.y - a.y * b.x;
}

/// A vector from the eye towards the point; its length does not matter.
template <typename T>
Vector<T> towards(const Vec<2>& eye, const Vec<2>& p) {
    return difference<T>(p, eye);
}

/// Here the vector may point away from the eye: see side().
template <typename T>
Vector<T> towards(const Vec<2>& eye, const Crossing& p) {
    // The crossing divides s in the ratio of the distances of its ends to the line of t.
    const Vector<T> along = difference<T>(p.t[1], p.t[0]);
    const T weight0 = cross_of(along, difference<T>(p.s[1], p.t[0]));
    const T weight1 = -cross_of(along, difference<T>(p.s[0], p.t[0]));
    const Vector<T> end0 = difference<T>(p.s[0], eye), end1 = difference<T>(p.s[1], eye);
    return {weight0 * end0.x + weight1 * end1.x, weight0 * end0.y + weight1 * end1.y};
}

/// +1 when towards() points to the point, -1 when it points away.
int side(const Vec<2>&) { return 1; }
int side(const Crossing& p) { return orient(p.t[0], p.t[1], p.s[1]); }

template <typename P, typename Q>
int turn(const Vec<2>& eye, const P& p, const Q& q) {
    const int sides = side(p) * side(q);  // before the rounding mode changes: orient() counts on the usual one
    {
        const Interval::Protector protect;
        const CGAL::Uncertain<CGAL::Sign> sign =
            CGAL::sign(cross_of(towards<Interval>(eye, p), towards<Interval>(eye, q)));
        if (CGAL::is_certain(sign)) return sides * CGAL::get_certain(sign);
    }
    return sides * CGAL::sign(cross_of(towards<Rational>(eye, p), towards<Rational>(eye, q)));
}

Vec<2> clamped(const Segment& s, const Vec<2>& p) { return glm::clamp(p, glm::min(s[0], s[1]), glm::max(s[0], s[1])); }

/// Where the line through `origin` along the given vector meets s.
Vec<2> meet_exactly(const Segment& s, const Vec<2>& origin, const Vector<Rational>& along) {
    const Rational side0 = cross_of(along, difference<Rational>(s[0], origin));
    const Rational side1 = cross_of(along, difference<Rational>(s[1], origin));
    const Rational part = side0 / (side0 - side1);
    const Vector<Rational> whole = difference<Rational>(s[1], s[0]);
    return clamped(
        s, {to_nearest(to_rational(s[0].x) + part * whole.x), to_nearest(to_rational(s[0].y) + part * whole.y)});
}

/// Where the line pq meets s.
Vec<2> meet(const Segment& s, const Vec<2>& p, const Vec<2>& q) {
    const Vec<2> along = q - p, end0 = s[0] - p, end1 = s[1] - p, whole = s[1] - s[0];
    const double side0 = sightline::cross(along, end0), side1 = sightline::cross(along, end1);
    const double size = std::abs(along.x * end0.y) + std::abs(along.y * end0.x) + std::abs(along.x * end1.y) +
                        std::abs(along.y * end1.x);
    const double part = side0 / (side0 - side1);
    const Vec<2> result = s[0] + part * whole;
    // Both sides are right to 4e-16 of their terms, so `part` is right to about 1e-15 size / |side0 - side1|.
    const double length = std::max(std::abs(whole.x), std::abs(whole.y));
    const double largest = std::max({std::abs(s[0].x), std::abs(s[0].y), std::abs(s[1].x), std::abs(s[1].y)});
    const double error = 1e-15 * size / std::abs(side0 - side1) * length;
    if (size > 1e-280 && error < 9e-15 * largest) return clamped(s, result);
    return meet_exactly(s, p, difference<Rational>(q, p));
}

}  // namespace

int orient(const Vec<2>& eye, const Crossing& p, const Vec<2>& q) { return turn(eye, p, q); }
int orient(const Vec<2>& eye, const Crossing& p, const Crossing& q) { return turn(eye, p, q); }

Vec<2> rounded(const Crossing& p) { return meet(p.s, p.t[0], p.t[1]); }

Vec<2> hit(const Segment& s, const Vec<2>& eye, const Vec<2>& p) { return meet(s, eye, p); }

Vec<2> hit(const Segment& s, const Vec<2>& eye, const Crossing& p) {
    return meet_exactly(s, eye, towards<Rational>(eye, p));
}

}  // namespace sightline
