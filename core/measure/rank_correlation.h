// Whether two orders agree.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace sightline {

/// Spearman's rank correlation of pairs, in [-1, 1]: 1 where both grow together, -1 where one grows as the other
/// falls. Equal values share the mean of their ranks. NaN with fewer than three pairs, or where all values of one side
/// are equal. Both of one length, finite or infinite, no NaN.
double rank_correlation(std::span<const double> a, std::span<const double> b);

}  // namespace sightline
