// Assimp's side of import_mesh(): runs in a process of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/process/child_process.h"
#include "core/scene/scene.h"

namespace sightline {

/// What is sent first; unless it failed, `triangles` Primitive<3> follow, then, if any is two-sided, a byte for each,
/// and then, if there are two objects at least, an AssimpObject for each.
struct AssimpHeader {
    std::uint64_t triangles = 0;
    std::uint64_t objects = 0;  ///< nodes with meshes
    std::uint8_t failed = 0, any_two_sided = 0, up_axis = 1, has_camera = 0, names_up = 0;
    ViewSpec<3> camera{};
    char text[400] = {};     ///< the format, or why it failed
    char warning[400] = {};  ///< the first thing that Assimp found wrong and passed over
};

/// The next triangles, by the name of their node or mesh.
struct AssimpObject {
    std::uint64_t triangles = 0;
    char name[128] = {};
};

/// Reads a file with Assimp and sends it. See import_mesh() for what it means.
void read_with_assimp(const std::string& path, const ChildProcess::Send& send);

}  // namespace sightline
