// What a picture in three dimensions shows, as flat memory for WebGL.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/draw/solid_list.h"

namespace sightline {

/// A corner of a triangle or an end of an edge, from the eye on.
struct SolidCorner {
    float x = 0, y = 0, z = 0;
    std::array<std::uint8_t, 4> colour{};
    float lit = 0;  ///< 1: shaded by its angle to the light
};

/// Three corners a triangle, those that one sees through behind the others, farthest first; two an edge.
struct Solid {
    std::vector<SolidCorner> triangles, edges;
    std::uint32_t opaque = 0;      ///< corners of triangles before the first that one sees through
    std::array<float, 16> clip{};  ///< column by column: camera_matrix.h, for depths from -1 to 1, reversed
    std::array<float, 3> forward{}, lamp{};
    Colour background;
};

Solid make_flat(const SolidList& list);

}  // namespace sightline
