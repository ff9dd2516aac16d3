// One scene and path: fits the cost model, works out the table, walks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/methods/by_viewpoint/by_viewpoint.h"
#include "core/methods/method_table.h"
#include "lab/lab_graphics.h"
#include "lab/measure/study.h"
#include "lab/viewpoint/viewpoint_results.h"

namespace sightline::lab {

struct ViewpointOptions {
    std::string method = std::string(by_viewpoint_id);
    std::string table;  ///< a file; empty: none
    ImageSize image;
    std::size_t frames = 0;  ///< so many, spread evenly over the path; 0: all
    std::size_t fit_views = 24;
    int repeats = 3, threads = 0;
    bool calibrates = true, fills = false, sizes = false;
};

/// Nothing when it was interrupted: what the table has so far is written first, where it has a file. Throws InputError.
std::optional<ViewpointScene> measure_viewpoint(const SceneOnPath& where, const ViewpointOptions& options,
                                                const MethodTables& tables, LabGraphics& graphics);

}  // namespace sightline::lab
