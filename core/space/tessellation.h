// What decides how space is cut into cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/words.h"

namespace sightline {

enum class Tessellation : std::uint8_t { delaunay, tree, kd };
enum class Border : std::uint8_t { inflated, none };
enum class EmptyLeaves : std::uint8_t { keep, drop, merge };
enum class SplitFor : std::uint8_t { vertices, opacity };
enum class Neighbours : std::uint8_t { facet, touching };
template <>
inline constexpr auto words<Tessellation> = std::to_array<std::string_view>({"delaunay", "tree", "kd"});
template <>
inline constexpr auto words<Border> = std::to_array<std::string_view>({"inflated", "none"});
template <>
inline constexpr auto words<EmptyLeaves> = std::to_array<std::string_view>({"keep", "drop", "merge"});
template <>
inline constexpr auto words<SplitFor> = std::to_array<std::string_view>({"vertices", "opacity"});
template <>
inline constexpr auto words<Neighbours> = std::to_array<std::string_view>({"facet", "touching"});

inline constexpr std::size_t tessellation_count = words<Tessellation>.size();

struct TessellationSettings {
    Tessellation tessellation = Tessellation::delaunay;
    double error_bound = 0.05;  ///< the largest side of a leaf, as a share of the longest side of the scene
    Border border = Border::inflated;
    double jitter = 0.02;  ///< of a leaf's centre, in sides of the leaf
    std::uint64_t seed = 1;
    std::uint32_t leaf_capacity = 1;  ///< points that a leaf may hold and stay whole
    EmptyLeaves empty_leaves = EmptyLeaves::keep;
    Neighbours neighbours = Neighbours::facet;
    SplitFor split_for = SplitFor::vertices;
    double opacity_tolerance = 0.1;  ///< with split_for=opacity: how much opacities may differ and count as the same
    bool operator==(const TessellationSettings&) const = default;
};

}  // namespace sightline
