// Exact rationals to and from doubles, the same with every library of large numbers. Pulls in CGAL, so only .cpp files
// include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_rational.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace sightline {

using Rational = CGAL::Exact_rational;

/// The number itself. Boost's rationals throw at doubles below 1e-292, so that small ones come by way of larger ones.
inline Rational to_rational(double value) {
    if (value == 0 || std::abs(value) > 1e-200) return Rational(value);
    constexpr double factor = 0x1p500;  // exact, and far from the largest double
    return Rational(value * factor) / Rational(factor);
}

/// The nearest double, of two the one whose last bit is 0: GMP cuts off and Boost rounds, so that their own differ by
/// one unit. Beyond the largest double: that one.
inline double to_nearest(const Rational& value) {
    constexpr double largest = 0x1.fffffffffffffp1023;
    if (value == 0) return 0;
    if (value < 0) return -to_nearest(-value);
    double result = CGAL::to_double(value);
    if (!(result <= largest)) return largest;
    const auto beyond = [&](double at, double next) -> Rational {  // GMP's expressions only refer to their terms
        return 2 * value - to_rational(at) - to_rational(next);
    };
    for (;;) {
        const double up = std::nextafter(result, INFINITY), down = std::nextafter(result, 0);
        const bool odd = std::bit_cast<std::uint64_t>(result) & 1;
        if (up <= largest) {
            const Rational over = beyond(result, up);
            if (over > 0 || (odd && over == 0)) {
                result = up;
                continue;
            }
        }
        if (result > 0) {
            const Rational under = beyond(down, result);
            if (under < 0 || (odd && under == 0)) {
                result = down;
                continue;
            }
        }
        return result;
    }
}

}  // namespace sightline
