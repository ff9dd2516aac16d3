// Exact rationals to and from doubles, the same with every library of large numbers. Pulls in CGAL, so only .cpp files
// include it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_rational.h>

#include <algorithm>
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
/// one unit, and Boost's is far off where doubles lose digits. Beyond the largest double: that one.
inline double to_nearest(const Rational& value) {
    if (value < 0) return -to_nearest(-value);
    constexpr auto largest = std::bit_cast<std::uint64_t>(0x1.fffffffffffffp1023);
    // Doubles that are not negative have the order of their bits.
    const auto number = [](std::uint64_t bits) { return to_rational(std::bit_cast<double>(bits)); };
    const double about = CGAL::to_double(value);
    std::uint64_t low = about >= 0 ? std::min(std::bit_cast<std::uint64_t>(about), largest) : 0, high = low;
    for (std::uint64_t step = 1; low > 0 && number(low) > value; step *= 2) low -= std::min(step, low);
    for (std::uint64_t step = 1; high < largest && number(high) <= value; step *= 2)
        high += std::min(step, largest - high);
    while (high - low > 1) {
        const std::uint64_t middle = low + (high - low) / 2;
        (number(middle) <= value ? low : high) = middle;
    }
    const Rational over = 2 * value - number(low) - number(high);
    return std::bit_cast<double>(over > 0 || (over == 0 && low % 2 == 1) ? high : low);
}

}  // namespace sightline
