// Text formats of 3D models, looked at before Assimp sees them: it works in single precision and trusts counts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/geometry/vec.h"

namespace sightline {

struct MeshText {
    std::string error;                ///< "line 3: reason": not to be read at all
    bool empty = false;               ///< well-formed and without faces, which Assimp would call an error
    std::optional<std::string> text;  ///< the file with every vertex moved by -shift; nothing: read the file itself
    Vec<3> shift{};
};

/// For OBJ, OFF, PLY and ASCII STL, told by the path's ending; other files are left to Assimp.
///  - OFF and PLY that end before the vertices and faces that they announce are errors (Assimp crashes on them or goes
///    on for ever).
///  - All vertices are moved by origin_for() of the box of most of them, in double precision; most, because files may
///    hold a stray vertex at zero. Not where no axis needs it, in binary PLY, and in files whose vertices cannot be
///    told apart surely (homogeneous coordinates, say).
MeshText prepare_mesh_text(const std::string& path);

/// What makes the file no OBJ file: "line 3: \"hello\" begins no line of an OBJ file"; empty when nothing does.
std::string why_no_obj(const std::string& path);

}  // namespace sightline
