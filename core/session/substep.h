// Step into: a step in slow motion. Substep 0 takes the cell out of the front, 1 renders its primitives, 2 + i looks
// across facet i of the cell. Session::in_the_middle shows a step as far as one of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

namespace sightline {

/// The substep that looks across the first facet.
inline constexpr std::uint32_t first_facet_substep = 2;

/// How many substeps a step, 1 <= step <= recorded(), has: 2 + the facets that it looked across. 2 for orders of
/// primitives, and where the budget ended the step before the neighbours.
template <int D>
std::uint32_t substep_count(const Session<D>& session, std::uint32_t step);

}  // namespace sightline
