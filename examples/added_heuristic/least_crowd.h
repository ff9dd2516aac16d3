// A heuristic of one's own: solidity that never fades.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/cells/cell_method.h"

/// The key of B is that of A plus |A| / ρ_max: the crowd met on the way from the eye. Published solidity multiplies
/// what A hands on by v · n (TVCG fig. 5), so a wall is forgotten a few cells behind it; here it is not. A cell that
/// waits in the front keeps the smaller key, so that its key is the crowd on the emptiest way to it.
struct LeastCrowd {
    static constexpr double seed_key = 0;
    static constexpr sightline::OnReenqueue on_reenqueue = sightline::OnReenqueue::min;

    template <int D>
    sightline::Key key(const sightline::Problem<D>& problem, std::uint32_t a, double key_a,
                       const sightline::HalfFacet&) const {
        return key_a + problem.cells->count(a) / std::max(1.0, double(problem.cells->rho_max));
    }
};
