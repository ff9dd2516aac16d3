// A texture laid over a rectangle of the framebuffer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/gl/handles.h"

namespace sightline {

/// Made, used and destroyed while one OpenGL 3.3 context is current.
class TextureQuad {
public:
    TextureQuad();

    /// Fills the rectangle (framebuffer pixels, y up) with the texture, which has as many pixels. `blended`: over what
    /// is there, for a texture of colours already multiplied by their opacity, which drawing onto transparent black
    /// gives; `opacity` in [0, 1] on top of theirs. Leaves behind: this viewport, no blending, no program, no scissor
    /// test.
    void draw(GLuint texture, int x, int y, int w, int h, bool blended, float opacity = 1) const;

private:
    GlProgram program_;
    GLint corner_, opacity_;
    GlVertexArray layout_;
};

}  // namespace sightline
