// The lab's OpenGL: off screen, for references and for timed drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/draw/solid_list.h"
#include "core/measure/frame_clock.h"
#include "core/session/settings.h"
#include "core/truth/id_image.h"

namespace sightline::lab {

/// Made on first use, so that 2D studies need no OpenGL. Use from one thread.
class LabGraphics {
public:
    LabGraphics();
    ~LabGraphics();
    LabGraphics(const LabGraphics&) = delete;
    LabGraphics& operator=(const LabGraphics&) = delete;

    /// Where there is no OpenGL 3.3, in software, and says so on standard error.
    DrawIds draw_ids();
    /// Throws WorkError where there is no OpenGL 3.3.
    DrawSolid draw_solid();
    /// Lit, at this size.
    TimeDrawing time_drawing(const ImageSize& size);
    bool has_opengl();
    /// OpenGL's version and renderer, or that there is none.
    std::string description();

private:
    struct Made;
    Made& made();
    std::unique_ptr<Made> made_;
};

}  // namespace sightline::lab
