// Which method, cells and budget to take, from what was measured of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/run/budget.h"
#include "core/space/tessellation.h"

namespace sightline {

/// One of the dots of a trade-off (trade_off.h).
struct Offer {
    std::string variant;  ///< "published on_reenqueue=min"
    Tessellation tessellation = Tessellation::delaunay;
    Budget budget;
    double ms = 0;                ///< per frame; NaN: not measured
    double wrong = 0;             ///< share of pixels; NaN: not measured
    bool misses_nothing = false;  ///< at the reference's resolution
};

/// So few wrong pixels count as none that a person would see.
inline constexpr double unseen_wrong = 0.001;

/// Of the Pareto points the fastest with at most `most_wrong`, else the one with the fewest wrong pixels; of equals the
/// one that misses nothing. Index into the offers; nothing where none was measured.
std::optional<std::size_t> recommend(std::span<const Offer> offers, double most_wrong = unseen_wrong);

/// Whether what is visible is so much of what view culling draws that nothing else can save much: at least nine tenths,
/// in primitives. `drawn` and `visible` of each frame.
bool nearly_all_is_visible(std::span<const double> drawn, std::span<const double> visible);

}  // namespace sightline
