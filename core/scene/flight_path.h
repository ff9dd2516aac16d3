// Flight paths: the views of an eye that moves through a scene, frame by frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/vec.h"

namespace sightline {

/// Where to look from, in scene units. fov in degrees: 2D (0, 180) or 360 for all round; 3D vertical.
template <int D>
struct ViewSpec {
    Vec<D> eye{};
    Vec<D> look_at{};
    double fov = 60;
    bool operator==(const ViewSpec&) const = default;
};

/// Coordinates are those of the scene as it is loaded (its origin subtracted).
template <int D>
struct FlightPath {
    std::string id;  ///< e.g. "street"
    std::vector<ViewSpec<D>> frames;
    std::string scene{};  ///< name of the scene that it was recorded in; empty when it came with the scene
    Vec<D> origin{};      ///< that of the scene it was recorded in
    bool operator==(const FlightPath&) const = default;
};

/// Moves the frames into a scene of another origin.
template <int D>
void set_origin(FlightPath<D>& path, const Vec<D>& origin) {
    for (ViewSpec<D>& frame : path.frames) {
        frame.eye += path.origin - origin;
        frame.look_at += path.origin - origin;
    }
    path.origin = origin;
}

/// Which frames to take when only `wanted` of `count` are asked for: the first, the last and others spread evenly
/// between them; all when there are no more than that.
std::vector<std::size_t> spread_frames(std::size_t count, std::size_t wanted);

/// One JSON object: {"format": "sightline-path", "version": 1, "dimension": 3, "id": "street", "scene": "city",
/// "origin": [x, y, z], "frames": [{"eye": [x, y, z], "look_at": [x, y, z], "fov": 60}, …]}. Required are format,
/// version, dimension and frames, of which there must be one at least. Text that is no JSON is read as a table, see
/// flight_path_csv.h. Throws InputError "name: place: reason".
template <int D>
FlightPath<D> read_path(std::string_view text, const std::string& name);

/// Reading this back gives the same path, bit for bit. Finite coordinates only.
template <int D>
std::string write_path(const FlightPath<D>& path);

}  // namespace sightline
