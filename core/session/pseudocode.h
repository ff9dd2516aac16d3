// The traversal as numbered lines in our own words, filled with the values of a step: the loop and the key of a cell
// (TVCG figs 4 and 5; TR figs 5 and 6), or an order of primitives.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"

namespace sightline {

struct CodeLine {
    std::string text;
    int indent = 0;
    bool lit = false;    ///< where the session stands; exactly one line is
    std::string values;  ///< "cell 12, key 0.25"; empty where the line has none yet
    std::string source;  ///< "TVCG fig. 4, line 3"; empty where it is ours
};

/// The lines of the session's method under its settings. `substep`, below substep_count of the last step, says where in
/// that step to stand (substep.h); none, or step 0: between two steps.
template <int D>
std::vector<CodeLine> pseudocode(const Session<D>& session, std::optional<std::uint32_t> substep);

}  // namespace sightline
