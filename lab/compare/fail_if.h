// Conditions under which `lab compare` fails: "wrong worse than 0.5 %".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lab/compare/compare.h"

namespace sightline::lab {

/// By how much B may be worse than A.
struct FailIf {
    std::string text;  ///< as it was written
    Measure measure = Measure::wrong;
    double limit = 0;   ///< in the measure's unit, shares of 1
    bool of_a = false;  ///< the limit is a share of A's value
};

/// "MEASURE worse than NUMBER [%|UNIT]". MEASURE is one that can be better, or `time` for total_ms. "%" of a share is
/// points, of anything else a part of A's value; without it the number is in the measure's unit. Throws InputError.
FailIf parse_fail_if(std::string_view text);

/// A line for each pair in which it holds: B's mean is worse by more than the limit and, for times, by more than the
/// noise; other numbers have no noise, since both sides saw the same frames. Throws InputError where no pair has the
/// measure: nothing was compared.
std::vector<std::string> failures(const FailIf& condition, const std::vector<Pair>& pairs);

}  // namespace sightline::lab
