// Numbers that fit a float, held in doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sightline {

/// One of the nearest float values; |value| < 1e38. Veltkamp's splitting (Dekker 1971) instead of a cast: GCC 12 at -O3
/// sometimes drops a cast to float and back when it computes two coordinates at once.
inline double float_value(double value) {
    const double far = value * 0x1.00000008p29;  // 2^29 + 1: leaves 24 of 53 bits
    return far - (far - value);
}

}  // namespace sightline
