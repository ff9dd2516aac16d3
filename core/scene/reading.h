// How a person can ask for files to be read.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/words.h"

namespace sightline {

/// The axis of a 3D file that points up. `automatic`: what the format says; where it has no rule, guess_up().
/// `format`: its rule or its custom.
enum class Up : std::uint8_t { automatic, format, x, y, z };
template <>
inline constexpr auto words<Up> = std::to_array<std::string_view>({"auto", "format", "x", "y", "z"});

/// Coordinates of GeoJSON that are degrees: taken as plane numbers, or x times the cosine of the middle latitude.
enum class Degrees : std::uint8_t { as_is, scaled };
template <>
inline constexpr auto words<Degrees> = std::to_array<std::string_view>({"as_is", "scaled"});

}  // namespace sightline
