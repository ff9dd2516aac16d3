// Where the time of a frame goes, what it draws for it, and how often it draws: a table per scene and path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lab/report/papers_tables.h"
#include "lab/report/study_charts.h"

namespace sightline::lab {

/// A row per row of the group.
TextTable time_table(const Group& group);

inline constexpr const char* time_caption =
    "The total is traversal + upload + drawing, milliseconds each, medians over frames. perfect draws exactly V, the "
    "visible primitives; it is told which they are, so its total is upload and drawing alone, and the total over that "
    "is how far a method is from the best. Hz is 1000 over the total of a frame: mean and quartiles over frames.";

}  // namespace sightline::lab
