// A heuristic of one's own: solidity that never fades.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/traversal/state.h"
#include "core/traversal/terms.h"

/// The key of B is that of A plus |A| / ρ_max: the crowd met on the way from the eye. Published solidity multiplies
/// what A hands on by v · n (TVCG fig. 5), so a wall is forgotten a few cells behind it; here it is not. With
/// on_reenqueue = min a cell's key is the crowd on the emptiest way to it.
struct LeastCrowd {
    static constexpr double seed_key = 0;
    static constexpr bool updates_enqueued = true;  // a cell in the front is looked at again from each neighbour

    template <int D>
    static sightline::Terms terms(const sightline::Frame<D>& frame, std::uint32_t a, double key_a,
                                  const sightline::HalfFacet&) {
        sightline::Terms t;
        t.rho_a = key_a;
        t.count = frame.cells->count(a);
        t.density = t.count / frame.solidity_scale;
        t.weight = 1;
        t.unpenalised = t.key = t.density + t.weight * key_a;
        return t;
    }
};
