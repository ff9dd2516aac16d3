// Who wins where: for each share of wrong pixels the fastest way to it, and the fastest by any other method.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lab/report/papers_tables.h"
#include "lab/report/study_charts.h"

namespace sightline::lab {

/// The fastest row with at most such a share of wrong pixels, and the fastest of another method, on whatever cells;
/// nullptr: there is none. Rows without a total time, and `perfect`, which is told what is visible, do not count.
struct Winner {
    const Row* first = nullptr;
    const Row* second = nullptr;
};
Winner winner(const Group& group, double most_wrong);

/// A row per scene and path, a column per share of wrong pixels.
TextTable winners_table(const Results& results);

inline constexpr const char* winners_caption =
    "The method and budget that leave no more than such a share of the pixels wrong (mean over frames) in the least "
    "total time (traversal + upload + drawing, milliseconds, median over frames), and after it the fastest other "
    "method. Only budgets that were measured count. Orders that bring what is large or near (layers, flux, tri) win "
    "where a few pixels may be wrong: most pixels belong to few primitives. The last wrong pixels belong to small "
    "primitives here and there, which such an order brings late, among many hidden ones; then it takes less time to "
    "hold boxes against what is drawn and find all (boxes, two-pass), or, where little is hidden, to draw all in view.";

}  // namespace sightline::lab
