// glTF 2.0: its JSON and its buffers, read here, in double precision and with a word for all that is left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/scene/read/import_mesh.h"

namespace sightline {

/// As import_mesh(): appends the triangles of the file's scene (the first, where it names none) to `scene`, each node
/// with a mesh an object. Read are triangles, strips and fans with and without indices, of all types of numbers,
/// quantised ones too, in buffers of the file, beside it and inside the text, sparse ones too; default weights of
/// morph targets, the rest position of skins, two-sided materials, hidden nodes, cameras and their animations.
/// Refused are unknown required extensions, a newer version, and references and counts that do not fit; a triangle
/// whose indices do not exist, points and lines are left out with a warning. Nothing, and nothing done: it is glTF 1.
std::optional<ImportedFile> read_gltf(const std::string& path, const std::string& name, const std::string& place,
                                      Scene<3>& scene);

}  // namespace sightline
