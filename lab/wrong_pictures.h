// Pictures of the frames in which a method does worst.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/lab_graphics.h"
#include "lab/results.h"

namespace sightline::lab {

struct WorstFrame {
    std::string scene, path, method, budget;
    std::uint32_t frame = 0;     ///< of the path
    double wrong = 0;            ///< share of pixels
    std::filesystem::path file;  ///< of the picture
    std::string command;         ///< opens it in the viewer
};

/// For each 3D scene and path and each approximate method the frame with the most wrong pixels at the middle budget:
/// the rendered image with what it misses in red, as PNG into `folder`.
std::vector<WorstFrame> draw_worst_frames(const Results& results, const Study& study,
                                          const std::filesystem::path& folder, LabGraphics& graphics);

}  // namespace sightline::lab
