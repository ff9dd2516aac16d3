// Pictures of frames: what a budget renders, and what it misses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/lab_graphics.h"
#include "lab/lab_scene.h"
#include "lab/results.h"

namespace sightline::lab {

struct WorstFrame {
    std::string scene, path, method, budget;
    std::uint32_t frame = 0;  ///< of the path
    double wrong = 0;         ///< share of pixels
    std::filesystem::path file;
    std::string command;  ///< opens it in the viewer
};

struct FramePicture {
    std::string scene, path, method, budget;
    std::uint32_t frame = 0;     ///< of the path
    double wrong = 0;            ///< share of pixels
    std::filesystem::path file;  ///< PNG
    std::string command;         ///< opens the frame in the viewer
};

/// What `rendered` draws, of the size of the exact image of its view, and red the pixels where its triangles are not
/// what should be seen (TVCG fig. 14).
Pixels missed_in_red(const SolidList& rendered, const IdImage& exact, LabGraphics& graphics);

/// The rendered image of one frame of a row, with what it misses in red (TVCG fig. 14); `frame` is an index into
/// Row::frames, and `lab` has the frames of the row.
FramePicture draw_frame(const LabScene<3>& lab, const Study& study, const Row& row, std::size_t frame,
                        const std::filesystem::path& file, LabGraphics& graphics);

/// For each 3D scene and path and each approximate method the frame with the most wrong pixels at the middle budget.
std::vector<FramePicture> draw_worst_frames(const Results& results, const Study& study,
                                            const std::filesystem::path& folder, LabGraphics& graphics);

}  // namespace sightline::lab
