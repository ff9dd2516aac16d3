// Wavefront OBJ: polygons and their groups.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/scene/read/parsed_mesh.h"

namespace sightline {

/// Of an OBJ file are read: v (a fourth number, where it is the last, divides the others), f (polygons, see
/// PolygonCutter; what stands behind a slash does not matter; vertices may come later), o and g. Objects are those of o
/// or, where there is none, the groups; those of one name are one. Comments stand on lines of their own or behind a
/// blank; a backslash at the end goes on in the next line. Points, lines and materials are left out, the files that a
/// model names are never opened.
///
/// Left out with a warning: faces of fewer than three corners, free-form curves and surfaces, lines that begin no line
/// of the format; where there is no triangle, the latter two are errors.
ParsedMesh read_obj(std::string_view bytes, const ShareDone& progress);

}  // namespace sightline
