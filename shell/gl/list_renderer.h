// Draws a draw list's shapes with OpenGL; labels are the window's.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "shell/gl/list_mesh.h"
#include "shell/gl/program.h"

namespace sightline {

/// What of the scene is seen, in which part of the framebuffer.
struct ListView {
    Box<2> world;                    ///< fills the rectangle exactly: both have the same aspect
    int x = 0, y = 0, w = 0, h = 0;  ///< framebuffer pixels, y up from the bottom
    double px_per_pt = 4.0 / 3;      ///< pixels per point of widths, marks and hatches
    double line_scale = 1;           ///< times the widths and marks, e.g. 2 for a projector
};

/// Made, used and destroyed while one OpenGL 3.3 context is current. Each list is uploaded once; views are free.
class ListRenderer {
public:
    ListRenderer();

    /// Keeps a copy of the list's shapes on the card.
    void set(const DrawList& list);

    /// Draws them over what the bound framebuffer has, cut to the view's rectangle. Sets and leaves behind: the
    /// viewport (the view's), the blend function, and no program, vertex array or blending, no scissor, depth or
    /// stencil test, no culling of faces. Lines have smooth edges of their own; fills only where the framebuffer has
    /// several samples. Draws nothing for an empty view.
    void draw(const ListView& view) const;

private:
    struct Program {
        GlProgram program;
        GLint scale, shift, half_view, pt, hatch, anchor;
    };
    static Program make(MeshRun::Kind kind);

    std::array<Program, 3> programs_;  ///< by MeshRun::Kind
    GlVertexArray layout_;
    GlBuffer vertices_, indices_;
    ListMesh mesh_;
};

}  // namespace sightline
