// How long tests of random input go on: "./run soak" multiplies what "./run test" tries.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <stdexcept>

namespace sightline::test {

/// How many random inputs to try, `count` in "./run test": times SIGHTLINE_SOAK, which "./run soak" sets to 100.
/// Generators start from the same seeds, so that a soak begins with what a test tries.
inline int soak_count(int count) {
    const char* const text = std::getenv("SIGHTLINE_SOAK");
    if (!text) return count;
    const int factor = std::atoi(text);
    if (factor < 1 || factor > 10'000) throw std::invalid_argument("SIGHTLINE_SOAK is no factor from 1 to 10000");
    return count * factor;
}

}  // namespace sightline::test
