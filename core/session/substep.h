// Step into: a step in slow motion. What its substeps are is the method's: methods/cells/cell_base.h for cells.
// Session::in_the_middle shows a step as far as one of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

namespace sightline {

/// How many substeps a step, 1 <= step <= recorded(), has.
template <int D>
std::uint32_t substep_count(const Session<D>& session, std::uint32_t step);

}  // namespace sightline
