// Predicates next to degenerate against exact rationals, for node: predicates [COUNT], status 1 if one differs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/near_degenerate.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    const auto found = sightline::test::try_near_degenerate(argc > 1 ? std::atol(argv[1]) : 100'000);
    std::printf(
        "%ld inputs, %ld of them collinear, %ld coplanar, %ld with a crossing: %ld wrong, %ld not rounded to nearest\n",
        found.inputs, found.collinear, found.coplanar, found.crossings, found.wrong, found.rounded);
    return found.wrong + found.rounded != 0;
}
