// What a timeline shows: one value per recorded step and lane, as plain data.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

namespace sightline {

/// Entry i belongs to step i + 1; all lanes have recorded() entries, wherever the session stands.
struct Lanes {
    std::vector<std::uint32_t> cell;      ///< popped; none for orders of primitives
    std::vector<std::uint32_t> visible;   ///< primitives rendered in the step that are in V
    std::vector<std::uint32_t> hidden;    ///< and those that are not
    std::vector<std::uint32_t> rendered;  ///< primitives rendered so far
    std::vector<std::uint32_t> front;     ///< cells in the front after the step
    std::vector<double> key;              ///< of the popped cell; NaN where there is none
    std::vector<double> coverage;         ///< so far, in [0, 1]; NaN when |V| = 0
    std::vector<double> oracle;           ///< the best possible with as many primitives; NaN when |V| = 0
};

/// Cost: steps + primitives + cells, and the reference where it is not made yet.
template <int D>
Lanes make_lanes(const Session<D>& session);

/// The first recorded step, from 0, after which at least `rendered` primitives are rendered; recorded() when there is
/// none.
template <int D>
std::uint32_t step_of_rendered(const Session<D>& session, std::uint32_t rendered);

}  // namespace sightline
