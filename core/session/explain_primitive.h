// Where a primitive is, whether it is visible, and when the run rendered it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/session/session.h"

namespace sightline {

struct PrimitiveExplanation {
    std::uint32_t primitive = none;
    bool visible = false;
    bool culled = false;               ///< met, but outside the view: not rendered
    std::uint32_t met_at = 0;          ///< the recorded step, done or to come, that meets it; 0: none does
    std::vector<std::uint32_t> cells;  ///< those that hold it
};

/// Cost: steps + primitives + references.
template <int D>
PrimitiveExplanation explain_primitive(const Session<D>& session, std::uint32_t primitive);

/// `position` tells what is done from what is to come: "Segment 12 is visible; step 7 will render it; it lies in cells
/// 3 and 4."
template <int D>
std::string sentence(const PrimitiveExplanation& primitive, std::uint32_t position);

}  // namespace sightline
