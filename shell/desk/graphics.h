// What 3D needs of OpenGL, handed in by whoever has it: the bench itself knows none.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/draw/solid_list.h"
#include "core/measure/frame_clock.h"
#include "core/truth/id_image.h"

namespace sightline {

/// Empty functions where there is no OpenGL: references in 3D are then drawn in software, and pictures throw WorkError.
struct Graphics {
    DrawIds draw_ids{};
    DrawSolid draw_solid{};
    std::function<TimeDrawing(const ImageSize& size)> time_drawing{};
    Progress progress{};  ///< of reading scenes
};

}  // namespace sightline
