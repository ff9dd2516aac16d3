// Formats that the project's own readers do not read. Assimp does; a program without it links other functions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "core/scene/read/import_mesh.h"

namespace sightline {

/// As import_mesh(), which calls it for whatever has no reader of its own.
ImportedFile import_other(const std::string& path, const std::string& name, const std::string& place, Scene<3>& scene,
                          const std::function<void(double share)>& progress);

/// Whether that reads files with this ending (".3ds").
bool is_other_ending(const std::string& ending);

/// All of them.
std::set<std::string> other_endings();

}  // namespace sightline
