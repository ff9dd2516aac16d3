// PLY: vertices and faces of any types, as text or binary.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/scene/read/parsed_mesh.h"

namespace sightline {

/// Of a PLY file (1.0: ascii, binary of either byte order) are read: x, y and z of the element vertex, wherever they
/// stand and whatever their type; the list vertex_indices or vertex_index of the element face (polygons, see
/// PolygonCutter) and of tristrips, of which every second triangle is turned and in which a negative index begins
/// anew. All else is passed over; what holds indices of vertices and is not read (range grids, say) is a warning, and
/// an error where there is no face. Files that end before what they announce are refused, from the header where it
/// shows there.
ParsedMesh read_ply(std::string_view bytes, const ShareDone& progress);

}  // namespace sightline
