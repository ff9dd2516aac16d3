// The nodes of a glTF file: where they stand, what of them is shown, and how its cameras move.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/flight_path.h"

namespace sightline {

class GltfDocument;

/// What places a node in its parent: a matrix, or these three.
struct GltfPlace {
    Vec<3> translation{0, 0, 0}, scale{1, 1, 1};
    glm::dvec4 rotation{0, 0, 0, 1};  ///< a quaternion x, y, z, w
    std::optional<glm::dmat4> fixed;

    glm::dmat4 matrix() const;
};

struct GltfNodes {
    std::vector<GltfPlace> places;       ///< in the parent
    std::vector<std::uint32_t> parents;  ///< none: it has none
    std::vector<glm::dmat4> to_scene;    ///< in double precision
    std::vector<std::uint32_t> shown;    ///< of the scene, each before its children
    std::size_t scenes = 0;              ///< that the file has; 0: nothing is shown
    std::size_t unplaced = 0;            ///< nodes with a mesh that are in no scene
};

/// Of the file's scene (the first one, where it names none). Throws where nodes do not form trees.
GltfNodes gltf_nodes(const GltfDocument& file);

struct GltfCameras {
    std::optional<ViewSpec<3>> first;  ///< of those that are shown; look_at one unit ahead
    std::vector<FlightPath<3>> paths;
    std::vector<std::string> warnings;
};

/// Cameras that an animation moves become a path each, 25 frames a second; if there are several cameras, "cameras" has
/// a frame for each. look_at lies `ahead` units ahead.
GltfCameras gltf_cameras(GltfDocument& file, const GltfNodes& nodes, double ahead);

/// Between two quaternions along the great circle; `share` in [0, 1]. Without sine and cosine: by halving.
glm::dvec4 between(const glm::dvec4& from, const glm::dvec4& to, double share);

}  // namespace sightline
