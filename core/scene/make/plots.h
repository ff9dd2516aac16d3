// Inside core/scene: scenes that grow in area, plot by plot, without changing what is there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/hash.h"
#include "core/base/random.h"

namespace sightline {

/// A square of side 1 whose corner at the least x and y is (x, y).
struct Plot {
    int x, y;

    /// Squared distance of the plot's middle from the origin.
    double distance2() const { return (x + 0.5) * (x + 0.5) + (y + 0.5) * (y + 0.5); }
    /// The plot's own stream: what it holds depends on no other plot.
    Random random(std::uint64_t seed) const {
        Hash hash;
        hash.add(x);
        hash.add(y);
        return Random(seed + hash.value());
    }
};

/// At least `count` plots, those nearest the origin first: a longer list begins with every shorter one.
std::vector<Plot> plots_by_distance(std::size_t count);

}  // namespace sightline
