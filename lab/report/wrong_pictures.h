// Pictures of frames: what a budget renders, and what it misses.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/lab_graphics.h"
#include "lab/measure/lab_scene.h"
#include "lab/measure/results.h"

namespace sightline::lab {

struct FramePicture {
    std::string scene, path, method, budget;
    std::uint32_t frame = 0;     ///< of the path
    double wrong = 0;            ///< share of pixels
    std::filesystem::path file;  ///< PNG
    std::string command;         ///< opens the frame in the viewer
};

/// What `rendered` draws, of the size of the exact image of its view, and red the pixels that are `wrong` (1 each), not
/// what should be seen (TVCG fig. 14).
Pixels wrong_in_red(const SolidList& rendered, const IdImage& exact, std::span<const std::uint8_t> wrong,
                    LabGraphics& graphics);

/// One frame of a row; `frame` is an index into Row::frames, and `lab` has the frames of the row. 3D: what is rendered,
/// with what it misses in red (TVCG fig. 14); 2D: the end of the run as the viewer exports it. `study` says what the
/// command has to set.
template <int D>
FramePicture draw_frame(const LabScene<D>& lab, const Study& study, const Row& row, std::size_t frame,
                        const std::filesystem::path& file, LabGraphics& graphics);

}  // namespace sightline::lab
