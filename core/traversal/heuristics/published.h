// The solidity of TVCG fig. 5 (TR fig. 6), with a setting for each thing that the papers leave open.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/traversal/facet_geometry.h"
#include "core/traversal/star_shape.h"
#include "core/traversal/state.h"
#include "core/traversal/terms.h"

namespace sightline {

struct PublishedSolidity {
    static constexpr double seed_key = 0;
    /// A neighbour that is already in the front is updated again (TVCG fig. 4, line 10).
    static constexpr bool updates_enqueued = true;

    /// ρ_B = |A| / ρ_max + (v · n_B) ρ_A, and a penalty unless star-shaped. `a` was just projected with solidity
    /// `rho_a`; `half` is its facet towards B.
    template <int D>
    static Terms terms(const Frame<D>& frame, std::uint32_t a, double rho_a, const HalfFacet& half) {
        const CellComplex<D>& cells = *frame.cells;
        const Settings& set = frame.settings;
        Terms t;
        t.rho_a = rho_a;
        t.count = cells.count(a);
        t.density = std::min(t.count / frame.solidity_scale, frame.solidity_limit);
        const FacetGeometry<D> facet = facet_geometry(cells, half);
        t.alignment = cosine<D>(set.view_vector == ViewVector::eye ? facet.centroid - frame.view.eye : frame.forward,
                                facet.normal);
        t.weight = t.alignment;
        if (set.transfer_sign == TransferSign::clamp) t.weight = std::max(t.alignment, 0.0);
        if (set.transfer_sign == TransferSign::abs) t.weight = std::abs(t.alignment);
        t.unpenalised = t.density + t.weight * rho_a;
        t.key = t.unpenalised;
        if (set.star_shaped == Switch::on && set.penalty != Penalty::none) {
            t.star_tested = true;
            t.star_shaped = star_shaped(cells, half, frame.view.eye, cells.centre(half.neighbour));
            if (!t.star_shaped)
                t.key = set.penalty == Penalty::multiply ? t.key * set.penalty_amount : t.key + set.penalty_amount;
        }
        return t;
    }
};

}  // namespace sightline
