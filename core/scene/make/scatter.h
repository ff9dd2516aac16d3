// Inside core/scene: places for things that stand anywhere without touching one another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/geometry/vec.h"

namespace sightline {

/// A disc that no other one touches, and the stream for what stands in it.
struct Stand {
    Vec<2> centre;
    double radius;
    Random random;
};

/// `count` stands, those nearest the origin first, as close together as random throws put them: a longer list begins
/// with every shorter one. None comes within `clearance` of a point of `free`.
std::vector<Stand> scatter(std::uint64_t seed, std::size_t count, double smallest, double largest,
                           std::span<const Vec<2>> free, double clearance);

}  // namespace sightline
