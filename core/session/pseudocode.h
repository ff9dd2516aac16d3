// What the session's method does, as numbered lines filled with the values of a step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/session/session.h"

namespace sightline {

/// The lines of the session's run. `substep`, below substep_count of the last step, says where in that step to stand
/// (substep.h); none, or step 0: between two steps.
template <int D>
std::vector<CodeLine> pseudocode(const Session<D>& session, std::optional<std::uint32_t> substep);

}  // namespace sightline
