// OFF: vertices and faces as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/scene/read/parsed_mesh.h"

namespace sightline {

/// The keyword may be in small letters or missing; with ST, C and N before it, vertices have texture coordinates,
/// colours and normals, which are passed over as are the colours of faces. Comments go from # to the end of the line.
/// Where the file has a line for each vertex and face, what else stands on the line is passed over; otherwise numbers
/// may be spread over lines in any way. OFF in four dimensions and binary OFF are refused.
ParsedMesh read_off(std::string_view bytes, const ShareDone& progress);

}  // namespace sightline
