// One name for every scene: a catalogue id, a file, or a map of an installed game.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/reading.h"
#include "core/scene/scene.h"

namespace sightline {

/// Where Debian's package `freedoom` puts its WAD files.
inline constexpr const char* freedoom_folder = "/usr/share/games/doom";

struct LoadOptions {
    bool two_sided = false;  ///< WAD: also lines that can be seen through; 3D: all triangles are seen from both sides
    std::string games_folder = freedoom_folder;
    Progress progress{};    ///< 3D
    Up up = Up::automatic;  ///< 3D
    Degrees degrees = Degrees::as_is;
    bool choose_view = true;  ///< 3D: false where the start view is not needed: it is the file's camera, or none
};

/// In 2D `name` is, tried in this order:
///  - an id of the catalogue (./ID means the file of that name);
///  - a file: a Doom WAD, GeoJSON or the project's JSON, told apart by content; FILE.wad#MAP picks a map, FILE.wad
///    alone the file's first;
///  - freedoom1#E1M2, freedoom2#MAP01, freedoom1: a map of the installed package `freedoom`.
/// In 3D: an id of the catalogue with or without a size ("city:500k"), a file or a folder of meshes, or several:
/// "a.obj;b.obj" (read_mesh.h). Throws InputError "name: place: reason".
template <int D = 2>
Scene<D> load_scene(const std::string& name, const LoadOptions& options = {});
template <>
Scene<2> load_scene<2>(const std::string& name, const LoadOptions& options);
template <>
Scene<3> load_scene<3>(const std::string& name, const LoadOptions& options);

/// Maps of a WAD file by path, in its order. Throws InputError.
std::vector<std::string> list_wad_maps(const std::string& path);

/// Names that load_scene takes for the installed freedoom maps: "freedoom1#E1M1", …; empty when none is installed.
std::vector<std::string> installed_maps(const std::string& folder = freedoom_folder);

}  // namespace sightline
