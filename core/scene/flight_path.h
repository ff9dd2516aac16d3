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
    bool operator==(const FlightPath&) const = default;
};

}  // namespace sightline
