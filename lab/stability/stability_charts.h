// Stability as curves: over the distance that the eye moves, past a wall, and along a path.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lab/report/study_charts.h"
#include "lab/stability/stability.h"

namespace sightline::lab {

/// The rows of one scene, path and budget.
struct StabilityGroup {
    std::string scene, path, budget;
    std::vector<const StabilityRow*> rows;
};
/// In the order of the rows.
std::vector<StabilityGroup> stability_groups(const std::vector<StabilityRow>& rows);

/// A line per method. `along_path` has the rows of a study of the same scenes, paths and budgets.
std::vector<NamedChart> stability_charts(const StabilityGroup& group, const Results& along_path);

}  // namespace sightline::lab
