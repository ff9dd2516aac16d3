// The layer heuristic of the gem: a cell's key is its distance from the seed in facets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/traversal/state.h"
#include "core/traversal/terms.h"

namespace sightline {

struct LayerNumber {
    static constexpr double seed_key = 0;
    /// Only clean neighbours get a layer (gem, add_neighbors_to_front).
    static constexpr bool updates_enqueued = false;

    template <int D>
    static Terms terms(const Frame<D>&, std::uint32_t, double layer_a, const HalfFacet&) {
        Terms t;
        t.rho_a = layer_a;
        t.density = 1;
        t.weight = 1;
        t.unpenalised = t.key = layer_a + 1;
        return t;
    }
};

}  // namespace sightline
