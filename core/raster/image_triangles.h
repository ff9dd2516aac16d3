// The triangles of a scene as an image shows them, worked out in double precision, for an image of ids.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/image_size.h"
#include "core/raster/image_plane.h"

namespace sightline {

/// Triangles are cut where they lie beyond the image's border by more than its half size.
constexpr double cone_reach = 2;
/// The nearness of what is at distance w = 1: in the middle between the smallest float and 1.
constexpr double nearness_1 = 0x1p-63;

/// A corner of a triangle in the image. 16 bytes.
struct ImageCorner {
    float x = 0, y = 0;    ///< from -1 (left, top) to +1; y grows downwards
    float nearness = 0;    ///< 2^-63 over the distance w (ImagePlane): linear in x and y; in (0, 1]
    std::uint32_t id = 0;  ///< of the primitive
};

/// Appends three corners for each triangle that may cover the centre of a pixel, by ascending id: those of the
/// primitives from `next` on that turn a seen side to the eye (none where it is exactly edge-on), cut to the view's
/// cone (a little beyond the image's border). There is no near plane: what is seen from however near is there.
/// Neighbours that share an edge share its corners, also where they are cut. Stops when `limit` corners or a few more
/// are there; moves `next` on, to the number of primitives at the end.
void append_image_triangles(const Scene<3>& scene, const View<3>& view, const ImageSize& size, std::size_t& next,
                            std::size_t limit, std::vector<ImageCorner>& corners);

/// The same for one primitive. `plane`: image_plane(view).
void append_image_triangle(const Scene<3>& scene, const View<3>& view, const ImagePlane& plane, const ImageSize& size,
                           std::size_t primitive, std::vector<ImageCorner>& corners);

}  // namespace sightline
