// STL: facets, as text or binary.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/scene/read/parsed_mesh.h"

namespace sightline {

/// Text begins with "solid" and goes on with "facet" or "endsolid"; its keywords may be in capitals and its normals
/// missing, for corners decide which side is the front; solids are objects where there are several. All other files are
/// binary and must hold the facets that they announce; what follows these does not matter, and is a warning where it
/// could be another facet.
ParsedMesh read_stl(std::string_view bytes, const ShareDone& progress);

}  // namespace sightline
