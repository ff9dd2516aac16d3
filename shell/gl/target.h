// A picture that OpenGL draws off screen, and its pixels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/pixels.h"
#include "shell/gl/handles.h"

namespace sightline {

/// An RGBA8 framebuffer of width x height pixels.
class GlTarget {
public:
    /// samples > 1: drawn with up to that many samples a pixel. `depth`: with a depth buffer of floats. Throws
    /// WorkError when the driver cannot make it.
    GlTarget(int width, int height, int samples = 1, bool depth = false);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Drawing goes here until another framebuffer is bound; sets the viewport to all of it.
    void bind() const;
    /// The picture as a texture, after resolve().
    GLuint texture() const { return texture_.name(); }
    /// Brings what was drawn into the texture; does nothing for one sample. Binds the default framebuffer.
    void resolve() const;
    /// Resolves, then reads everything back.
    Pixels read() const;

private:
    int width_, height_;
    GlTexture texture_;
    GlFramebuffer single_;  ///< with the texture
    GlRenderbuffer samples_, depth_;
    GlFramebuffer multiple_;
    bool multisampled_;
};

}  // namespace sightline
