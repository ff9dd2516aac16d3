// What the methods of the family leave open.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/parameters.h"

namespace sightline {

/// What an order of primitives is to bring early: many visible ones, or those that show at many pixels.
enum class Maximise : std::uint8_t { count, pixels };
template <>
inline constexpr auto words<Maximise> = std::to_array<std::string_view>({"count", "pixels"});

const ParameterRow& maximise_row();

/// How light comes into a cell: through its facets, from the cells that were projected; or to its corners, through what
/// lies before them, projected or not.
enum class LightTransport : std::uint8_t { usual, facets, corners };
template <>
inline constexpr auto words<LightTransport> = std::to_array<std::string_view>({"usual", "facets", "corners"});

const ParameterRow& transport_row();

}  // namespace sightline
