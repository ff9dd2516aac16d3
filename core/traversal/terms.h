// The terms of a key: what a step adds up for one facet, kept apart so that it can be explained.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sightline {

/// key = density + weight * rho_a, then the penalty. Fields that a heuristic does not use stay at these defaults.
struct Terms {
    double rho_a = 0;         ///< key of the cell just projected
    std::uint32_t count = 0;  ///< |A|
    double density = 0;       ///< |A| / ρ_max, cut at 1 with solidity_scale = p95; or what the heuristic adds instead
    double alignment = 0;     ///< v · n_B in [-1, 1]
    double weight = 0;        ///< alignment after transfer_sign
    bool star_tested = false;
    bool star_shaped = true;
    double unpenalised = 0;
    double key = 0;

    bool penalised() const { return !star_shaped; }
    bool operator==(const Terms&) const = default;
};

}  // namespace sightline
