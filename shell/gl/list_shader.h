// The shaders that draw a mesh: they widen lines to pixels and smooth their edges.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shell/gl/list_mesh.h"

namespace sightline {

/// Sources for one kind of runs. Those of fills and lines are the mixed one with less in it: a software renderer pays
/// for every branch at every pixel.
std::string list_vertex_shader(MeshRun::Kind kind);
std::string list_fragment_shader(MeshRun::Kind kind);

}  // namespace sightline
