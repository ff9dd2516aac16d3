// Draws images of ids (the item buffer of TVCG section 4.4): which triangle each pixel shows, and what lies behind.
//
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/truth/id_image.h"
#include "core/raster/image_triangles.h"
#include "shell/gl/handles.h"

namespace sightline {

/// Made, used and destroyed while one OpenGL 3.3 context is current.
///
/// Which triangles turn a seen side to the eye, where their corners lie in the image and what a near plane would cut
/// off is worked out in doubles; OpenGL fills pixels only. So an image differs from exact arithmetic only where moving
/// the pixel's centre by a small part of a pixel changes what is seen there: corners are snapped to the driver's
/// subpixel grid (1/256 pixel for all known ones), depths are floats. Of triangles of equal depth the one of the lowest
/// id is seen.
class IdRenderer {
public:
    IdRenderer();

    /// As DrawIds asks. Throws WorkError when the driver cannot draw an image of this size. Leaves behind: the default
    /// framebuffer, a viewport of the image's size, no program, vertex array or texture, no depth, stencil or scissor
    /// test, no blending, no culling of faces, all written to, and GL_LESS as the depth test.
    std::vector<IdImage> draw(const Scene<3>& scene, const View<3>& view, const ImageSize& size, int layers);

private:
    /// Ids and depths of one layer.
    struct Layer {
        GlFramebuffer frame;
        GlTexture ids, depths;
    };
    static Layer make_layer(const ImageSize& size);
    void draw_triangles(const Scene<3>& scene, const View<3>& view);
    IdImage read() const;

    GlProgram nearest_, behind_;
    GlVertexArray layout_;
    GlBuffer corners_;
    std::vector<Layer> layers_;  ///< at most two: they take turns as the one drawn and the one before it
    ImageSize size_;             ///< theirs
    std::vector<ImageCorner> staged_;
};

}  // namespace sightline
