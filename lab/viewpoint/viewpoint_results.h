// What `lab viewpoint` measures: the cost model, the table and the walk, on each scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lab/measure/conditions.h"
#include "lab/viewpoint/calibrate.h"
#include "lab/viewpoint/viewpoint_walk.h"

namespace sightline::lab {

/// Working out entries beforehand.
struct TableFill {
    std::size_t known_before = 0;  ///< entries that a file had
    double seconds = 0;            ///< 0: it was not asked for
    MergedSize merged{};
    std::size_t file_bytes = 0;  ///< of the table as a file
};

/// A whole table with other intervals of directions.
struct TableSize {
    std::uint32_t azimuths = 0, elevations = 0;
    std::size_t intervals = 0;
    double seconds = 0;
    MergedSize merged{};
    std::size_t file_bytes = 0;
};

struct ViewpointScene {
    std::string scene, path, method;
    std::vector<std::uint32_t> frames;  ///< of the path
    std::size_t primitives = 0;
    std::size_t scene_bytes = 0;    ///< of the primitives
    std::vector<Calibration> fits;  ///< one a reading; empty: none was fitted
    std::shared_ptr<const Scene<3>> read;
    std::shared_ptr<const ViewpointTable<3>> table;
    TableFill fill;
    std::vector<TableSize> sizes;  ///< with more and more intervals; empty: not asked for
    ViewpointWalk walk;

    const Calibration& best_fit() const;  ///< by r2
    const std::vector<Variant<3>>& options() const { return table->problem().options; }
};

struct ViewpointResults {
    Conditions conditions;
    ImageSize image;
    int repeats = 0;
    std::vector<ViewpointScene> scenes;
};

}  // namespace sightline::lab
