// Inside core/scene: where everything stands on a campus, for both dimensions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/words.h"
#include "core/scene/make/campus_building.h"

namespace sightline {

/// A campus is a square between the middle lines of four streets, with one more street through its middle, along x.
inline constexpr double campus_side = 128, campus_half = campus_side / 2, kerb_edge = 60, middle_street = 4;
inline constexpr double kerb_height = 0.125;

struct CampusSite {
    Vec<2> corner;
    int quarter_turns;
    double length, depth;  ///< depth 0: as offices are deep
    int rooms_in_row, storeys;
    PlannedUse use = PlannedUse::office;
};
/// The first one is where the walk begins.
std::span<const CampusSite> campus_sites();
BuildingPlan site_plan(const CampusSite& site, Random& random);
/// A stream of its own for each thing.
Random campus_stream(std::uint64_t seed, int what, int which);

enum class OutdoorKind : std::uint8_t { lamp, bench, bollard, car, oak, fir, hedge };
template <>
inline constexpr auto words<OutdoorKind> = std::to_array<std::string_view>({"lamp post", "bench", "bollard", "car",
                                                                            "oak", "fir", "hedge"});

struct OutdoorThing {
    OutdoorKind kind;
    Vec<2> at;
    double degrees;
    Random own;
};
/// What stands along the streets, then on the lawn.
std::vector<OutdoorThing> outdoor_things(std::uint64_t seed);

}  // namespace sightline
