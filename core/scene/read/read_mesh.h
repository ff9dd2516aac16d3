// Files of 3D models, as one soup of triangles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/scene/reading.h"
#include "core/scene/scene.h"

namespace sightline {

struct MeshOptions {
    bool two_sided = false;  ///< every triangle is seen from both sides, whatever the files say
    Progress progress;
    Up up = Up::automatic;
    bool choose_view = true;  ///< see LoadOptions
};

/// Reads a file, or all files in a folder and its folders (sorted by path) whose ending is that of a 3D format. In a
/// folder, files that cannot be read are warnings unless none can. The triangles are cleaned and recentred (see
/// clean()); the start view is the file's first camera if it sees a triangle, else default_view(). What points up is
/// what the files or their formats say, else guess_up(), with a warning. `name` begins error lines and is the id. A
/// scene without triangles is valid and has a warning. Throws InputError "name: place: reason".
Scene<3> read_mesh(const std::string& path, const std::string& name, const MeshOptions& options = {});

/// The same for several files and folders, as one soup in the given order. A file that is named here must be readable.
Scene<3> read_meshes(std::span<const std::string> paths, const std::string& name, const MeshOptions& options = {});

}  // namespace sightline
