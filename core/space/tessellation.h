// What decides how space is cut into cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/words.h"

namespace sightline {

enum class Tessellation : std::uint8_t { delaunay, tree };
enum class Border : std::uint8_t { inflated, none };
template <>
inline constexpr auto words<Tessellation> = std::to_array<std::string_view>({"delaunay", "tree"});
template <>
inline constexpr auto words<Border> = std::to_array<std::string_view>({"inflated", "none"});

struct TessellationSettings {
    Tessellation tessellation = Tessellation::delaunay;
    double error_bound = 0.05;  ///< the largest side of a leaf, as a share of the longest side of the scene
    Border border = Border::inflated;
    double jitter = 0.02;  ///< of a leaf's centre, in sides of the leaf
    std::uint64_t seed = 1;
    bool operator==(const TessellationSettings&) const = default;
};

}  // namespace sightline
