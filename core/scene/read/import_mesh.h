// One 3D file: read by a reader of the project's own, or by Assimp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace sightline {

/// What a file says beside its triangles.
struct ImportedFile {
    std::string format;                  ///< "obj"; Assimp's first ending for the reader that took it: "3ds"
    int up_axis = 2;                     ///< see below
    std::optional<ViewSpec<3>> camera;   ///< the first camera; look_at one unit ahead
    std::vector<FlightPath<3>> paths{};  ///< of its cameras, in the file's coordinates
    bool names_up = true;                ///< the format, or the file, says which axis points up
};

/// Appends the triangles of a file to `scene`, in the file's coordinates as doubles, not cleaned, with the transforms
/// of its nodes (in double precision; mirrored ones swap two corners) and, where a material is two-sided, two_sided.
/// Polygons are cut into triangles; points and lines are left out; pictures and materials that are missing do not
/// matter. Coordinates of OBJ, OFF, PLY and STL, which are read here (read_obj.h and so on), are the file's; Assimp
/// holds those of other formats, and node transforms, as floats before they get here: where these are more than 1e-4
/// of the file's longest side apart, a warning says so, as it does of files that hold such floats themselves.
///
/// The axis that points up is what the file says (FBX) or: z for PLY, STL, OFF, 3MF, AMF and RAW, which have no rule or
/// whose rule is z; y for all others: OBJ's custom, glTF's rule, and Assimp turns the rest to y.
///
/// scene.objects grows by what the file names: the nodes of glTF, the objects of OBJ and STL, and the nodes of other
/// formats where there are two at least; where it names none it is left as it is.
///
/// glTF 2 is read by read_gltf(), what Assimp reads, which runs in a process of its own: bad files make it crash, and
/// its memory is free when this returns.
/// JoinIdenticalVertices is not asked for: a soup has no use for it, and it would double the memory and triple the
/// time. `progress` takes a share in [0, 1], estimated from the file's size (Assimp says little).
///
/// Throws InputError "name: place: reason", also where the ending is none of is_mesh_ending() or another one than that
/// of the format that Assimp found inside, and where it found no triangle though the file does not say that it has
/// none.
ImportedFile import_mesh(const std::string& path, const std::string& name, const std::string& place, Scene<3>& scene,
                         const std::function<void(double share)>& progress);

/// Whether files with this ending (".obj"; see ending_of()) hold triangles that this reads: not ".csm", which is
/// movement. Endings of formats that are mostly something else (".xml", ".raw") count as well.
bool is_mesh_ending(const std::string& ending);

/// Floats are apart by 2^-24 of their size: where that shows, in the scene from triangle `first` on, people should
/// know.
void warn_of_steps(Scene<3>& scene, std::size_t first, const std::string& place);

}  // namespace sightline
