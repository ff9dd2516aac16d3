// Depth that is 1 at the eye and 0 at infinity, for as long as one draws.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

namespace sightline {

/// From its making to its end depths are tested with GL_GREATER, written, and cleared to 0; afterwards as OpenGL starts
/// with: no depth test, GL_LESS, cleared to 1. Use with camera_matrix and GL_DEPTH_COMPONENT32F.
class ReversedDepth {
public:
    ReversedDepth() : zero_to_one_(epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control")) {
        if (zero_to_one_) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDepthMask(GL_TRUE);
        glClearDepth(0);
    }
    ~ReversedDepth() {
        if (zero_to_one_) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        glDisable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        glClearDepth(1);
    }
    ReversedDepth(const ReversedDepth&) = delete;
    ReversedDepth& operator=(const ReversedDepth&) = delete;

    /// Whether the driver maps depths from [0, 1] and so keeps the precision of small ones.
    bool zero_to_one() const { return zero_to_one_; }

private:
    bool zero_to_one_;
};

}  // namespace sightline
