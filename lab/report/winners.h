// Who wins where: for each share of wrong pixels the fastest way to it, and the fastest by any other method.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

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

/// What the table shows, what its times hold, and who wins how often where most and where fewest pixels may be wrong.
std::string winners_text(const Results& results);

}  // namespace sightline::lab
