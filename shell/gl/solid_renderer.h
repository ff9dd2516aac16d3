// Draws a solid list with OpenGL, in a window or as a picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/draw/solid_list.h"
#include "shell/gl/camera_matrix.h"
#include "shell/gl/program.h"
#include "shell/gl/scene_mesh.h"
#include "shell/gl/solid_mesh.h"

namespace sightline {

/// Opaque triangles and faces first; then translucent ones from back to front by the distance of their centres, sorted
/// when the eye moves; then edges, with smooth borders, where nothing lies before them. Lit from both sides by a lamp
/// at the eye and one above. Made, used and destroyed while one OpenGL 3.3 context is current. A list is uploaded once;
/// cameras are free.
class SolidRenderer {
public:
    SolidRenderer();

    /// Keeps what the list shows. The scene's triangles are uploaded when the scene is another than before. Throws
    /// WorkError when the card has no room for them.
    void set(const SolidList& list);

    /// Replaces the list's triangles and runs, which name its styles, and nothing else; for live frames. Cheap when all
    /// of them are opaque.
    void set_triangles(std::span<const SolidList::Run> runs, std::span<const std::uint32_t> triangles);

    /// Fills the rectangle (pixels of the bound framebuffer, which needs a depth buffer; y up) with the background and
    /// what the camera sees; its cone fills the rectangle. Leaves behind: the viewport (the rectangle) and no program,
    /// vertex array, blending, scissor, depth or stencil test. Draws nothing for an empty rectangle. `quick`: edges are
    /// plain lines of one pixel, which a software renderer draws in half the time; for a camera that moves.
    void draw(const View<3>& camera, int x, int y, int w, int h, double px_per_pt, bool quick = false);

    /// Sets the list and draws it off screen with 4 samples a pixel, in tiles where it is large: a DrawSolid. Binds the
    /// default framebuffer. Empty when a side is 0. Throws WorkError when a side is larger than largest_solid_picture.
    Pixels picture(const SolidList& list, int width, int height, double px_per_pt);

private:
    struct FaceProgram {
        GlProgram program;
        GLint clip, eye, eye_rest, forward, lamp, slice;
    };
    struct EdgeProgram {
        GlProgram program;
        GLint clip, eye, eye_rest, half_view, pt;
    };
    /// A range of the choice of triangles.
    struct Range {
        SolidStyle style;
        std::size_t first = 0, count = 0;
        bool all = false;  ///< each triangle of the scene, in their order
    };
    /// A rectangle of a picture of w x h pixels, y up.
    struct Part {
        int x = 0, y = 0, w = 0, h = 0;
    };

    static FaceProgram make_face_program();
    static EdgeProgram make_edge_program(const char* vertex, const char* fragment);
    void upload_faces();
    void sort_sheets(const Vec<3>& eye);
    void draw_faces(const CameraMatrix& camera, const Vec<3>& forward);
    void draw_edges(const CameraMatrix& camera, int w, int h, double px_per_pt, bool quick) const;
    /// Draws what of the w x h pixels of a whole picture lies in `part` into a viewport at x, y.
    void draw_part(const View<3>& camera, int w, int h, const Part& part, int x, int y, double px_per_pt, bool quick);

    FaceProgram face_program_;
    EdgeProgram edge_program_, line_program_;
    GlVertexArray face_layout_, edge_layout_;
    GlBuffer vertices_, opaque_, translucent_, edges_, edge_indices_, line_indices_;
    SolidMesh mesh_;
    std::size_t list_vertices_ = 0, list_sheets_ = 0,
                list_translucent_ = 0;  ///< of the mesh, those of the list's faces
    std::vector<SolidStyle> styles_;
    Colour background_{255, 255, 255};
    std::optional<Slice> slice_;
    std::shared_ptr<const Scene<3>> scene_;
    Box<3> scene_bounds_;
    std::optional<SceneMesh> scene_mesh_;
    TriangleChoice choice_;
    std::vector<Range> ranges_;
    std::optional<Vec<3>> sorted_for_;  ///< the eye that the sheets are sorted for
    std::vector<std::uint32_t> sorted_;
};

}  // namespace sightline
