// What `lab viewpoint` found: text, a table of frames, a chart of frame times.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "lab/measure/conditions.h"
#include "lab/report/chart.h"
#include "lab/viewpoint/calibrate.h"
#include "lab/viewpoint/viewpoint_walk.h"

namespace sightline::lab {

/// Working out entries beforehand.
struct TableFill {
    std::size_t known_before = 0;  ///< entries that a file had
    double seconds = 0;            ///< 0: it was not asked for
    MergedSize merged{};
    std::size_t file_bytes = 0;  ///< 0: none was written
};

struct ViewpointResults {
    Conditions conditions;
    std::string scene, path, method;
    std::vector<std::uint32_t> frames;  ///< of the path
    std::size_t scene_bytes = 0;        ///< of the primitives
    std::vector<Calibration> fits;      ///< one a reading; empty: none was fitted
    std::shared_ptr<const ViewpointTable<3>> table;
    TableFill fill;
    ViewpointWalk walk;

    const Calibration& best_fit() const;  ///< by r2
};

/// For the console, with all figures.
std::string viewpoint_text(const ViewpointResults& results);

/// viewpoint.csv, viewpoint.txt and frames.{svg,pdf,png,gp}. Throws WorkError.
void write_viewpoint(const ViewpointResults& results, const std::filesystem::path& folder, const ChartFormat& format);

}  // namespace sightline::lab
