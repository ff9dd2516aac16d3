// Where a run loses its first pixel for good.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/run/drawn.h"
#include "core/run/step.h"
#include "core/truth/reference.h"

namespace sightline {

/// A step after which no order of what is left makes the image as right as the budget allowed.
struct FirstWrong {
    std::uint32_t step = 0;     ///< from 1
    std::uint32_t missing = 0;  ///< visible primitives that are not rendered after it
    std::uint32_t left = 0;     ///< primitives that the budget still pays for
};

/// With m(s) visible primitives missing after step s and b(s) left of the budget, max(0, m(s) - b(s)) of them stay
/// missing whatever comes. The first recorded step that makes this number larger than max(0, |V| - budget), which no
/// order avoids: from there on the frame ends below the oracle. Nothing when no step does, e.g. without a budget.
/// `met` is that of the whole recording.
std::optional<FirstWrong> first_wrong(const Reference& reference, std::span<const Met> met, const Recording& recording,
                                      std::uint32_t budget);

}  // namespace sightline
