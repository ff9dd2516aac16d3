// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/self_test.h"

#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/geometry/predicates.h"

namespace sightline {

namespace {

using Whole = __int128;  // holds every sum and product below

int sign(Whole value) { return (value > 0) - (value < 0); }

/// A whole number of at most `bits` bits as the double that has just that value, times 2^-bits.
struct Grid {
    int bits;
    double step() const { return std::ldexp(1.0, -bits); }
    double round(double value) const { return std::nearbyint(value / step()) * step(); }
    Whole whole(double value) const { return static_cast<Whole>(value / step()); }
};

int exact(const Grid& grid, const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    const auto difference = [&](double p, double q) { return grid.whole(p) - grid.whole(q); };
    return sign(difference(a.x, c.x) * difference(b.y, c.y) - difference(a.y, c.y) * difference(b.x, c.x));
}

int exact(const Grid& grid, const std::array<Vec<3>, 4>& p) {
    Whole m[3][3];
    for (int i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis)
            m[i][axis] = grid.whole(p[static_cast<std::size_t>(i)][axis]) - grid.whole(p[3][axis]);
    return -sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

std::string told(const char* what, int expected, int got) {
    return std::string(what) + " should be " + std::to_string(expected) + " and is " + std::to_string(got);
}

}  // namespace

std::string predicates_fail(std::uint32_t inputs) {
    Random random(7);
    const Grid fine{52}, coarse{38};  // products of two, and of three, differences fit 127 bits
    for (std::uint32_t i = 0; i < inputs; ++i) {
        const auto unit = [&](const Grid& grid) { return grid.round(random.unit()); };
        const double ax = unit(fine), ay = unit(fine), bx = unit(fine), by = unit(fine), t = random.unit();
        const Vec<2> a(ax, ay), b(bx, by), c(fine.round(ax + t * (bx - ax)), fine.round(ay + t * (by - ay)));
        if (const int expected = exact(fine, a, b, c), got = orient(a, b, c); got != expected)
            return told("the turn of three points", expected, got);
        std::array<Vec<3>, 4> p;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = unit(coarse), y = unit(coarse), z = unit(coarse);
            p[k] = {x, y, z};
        }
        const double u = random.unit(), v = random.unit();
        for (int axis = 0; axis < 3; ++axis)
            p[3][axis] = coarse.round(p[0][axis] + u * (p[1][axis] - p[0][axis]) + v * (p[2][axis] - p[0][axis]));
        if (const int expected = exact(coarse, p), got = orient(p[0], p[1], p[2], p[3]); got != expected)
            return told("the side of a point of a plane", expected, got);
    }
    return "";
}

}  // namespace sightline
