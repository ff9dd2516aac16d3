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

/// How well budgets in time were kept: a row per flight.
TextTable budget_table(const Results& results);

inline constexpr const char* budget_caption =
    "A budget in time is one for the whole frame: traversal, upload and drawing. Frames follow one another along the "
    "path, and what the last ones cost to draw says when to stop. Kept are frames within the budget + 10 %, in % of "
    "all frames of all repeats; then milliseconds of the worst frame and medians. How far the cost of a frame varies "
    "is seen from drawing all in view (view): its least and most expensive frame.";

/// How well budgets in wrong pixels were kept: a row per flight.
TextTable wrong_budget_table(const Results& results);

inline constexpr const char* wrong_budget_caption =
    "A budget in wrong pixels follows the frames before: it is the most that one of the last eight needed, as far as "
    "they were drawn; a frame that had too little counts for twice its budget. Kept are frames within the share + 10 "
    "%, "
    "in % of all but the first, which nothing is known of; then means over these frames. What they needed is known to "
    "the reference alone.";

}  // namespace sightline::lab
