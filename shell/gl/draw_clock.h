// How long OpenGL takes to draw some of a scene's triangles: off screen, lit, at a size of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/image_size.h"
#include "core/measure/frame_clock.h"
#include "shell/gl/solid_renderer.h"
#include "shell/gl/target.h"

namespace sightline {

/// Made, used and destroyed while one OpenGL 3.3 context is current.
class DrawClock {
public:
    /// As TimeDrawing, with glFinish before and after each time taken. Binds the default framebuffer.
    DrawTimes time(const ImageSize& size, const std::shared_ptr<const Scene<3>>& scene, const View<3>& view,
                   std::span<const std::uint32_t> triangles);

private:
    SolidRenderer solids_;
    std::optional<GlTarget> target_;
    std::shared_ptr<const Scene<3>> scene_;
};

}  // namespace sightline
