// Which method, cells and budget to take, from what was measured of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
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
    double error = 0;             ///< standard error of `ms`; NaN: not known
};

/// So few wrong pixels count as none that a person would see.
inline constexpr double unseen_wrong = 0.001;

/// Of the Pareto points the fastest with at most `most_wrong`, else the one with the fewest wrong pixels; of equals the
/// one that misses nothing. Index into the offers; nothing where none was measured.
std::optional<std::size_t> recommend(std::span<const Offer> offers, double most_wrong = unseen_wrong);

/// Of the offers with another variant or other cells the fastest with as few wrong pixels, or at most `most_wrong`, if
/// another measurement might well find it to be faster: it takes at most a tenth longer, or two standard errors.
std::optional<std::size_t> close_second(std::span<const Offer> offers, std::size_t best,
                                        double most_wrong = unseen_wrong);

/// What the view shows, as far as it decides how much any culling can save.
enum class InView : std::uint8_t {
    much_hidden,
    nearly_all_visible,  ///< at least nine tenths in each frame, in primitives: nothing saves much
    nothing_visible,     ///< in any frame, though something is drawn: nothing can be told apart
    nothing              ///< no frame has anything to draw
};

/// `drawn` by view culling and `visible`, of each frame; without a frame much_hidden.
InView what_is_in_view(std::span<const double> drawn, std::span<const double> visible);

}  // namespace sightline
