// The gem's figures for PLP and cPLP in a power plant beside ours: frames per second, and pixels that are right.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lab/report/papers_tables.h"

namespace sightline::lab {

/// Theirs, then every row of ours with the order by layers or cPLP on a whole path through `plant`. No rows where the
/// study has none of these.
TextTable gem_table(const Results& results);

inline constexpr const char* gem_caption =
    "Frames per second and pixels that are right: the mean over frames, and what three frames in four exceed. Theirs: "
    "13 million triangles, 500 frames, a Pentium III at 733 MHz with a GeForce2. Their data are not available; the "
    "generated plant stands in for them, and the machine is another, so compare the rows with one another.";

/// Share of right pixels over the frames of a row.
Spread right_pixels(const Row& row);

}  // namespace sightline::lab
