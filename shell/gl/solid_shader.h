// The shaders that draw a solid list: they light faces and widen edges to pixels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sightline {

/// Triangles of faces and of the scene: one colour each, made by the vertex shader, for a software renderer pays at
/// every pixel.
extern const char* const solid_face_vertex_shader;
extern const char* const solid_face_fragment_shader;

/// Edges as lines of one pixel; goes with the fragment shader of faces.
extern const char* const solid_line_vertex_shader;

/// Quads of edges, with smooth borders of their own.
extern const char* const solid_edge_vertex_shader;
extern const char* const solid_edge_fragment_shader;

}  // namespace sightline
