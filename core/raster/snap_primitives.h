// Primitives of a scene as triangles on the raster's grid, many at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/raster/fixed_triangle.h"

namespace sightline {

/// A view and an image of it, worked out once.
struct ImageOf {
    const Scene<3>* scene = nullptr;
    const View<3>* view = nullptr;
    ImagePlane plane{};
    ImageSize size{};

    ImageOf() = default;
    ImageOf(const Scene<3>& of, const View<3>& seen, const ImageSize& pixels)
        : scene(&of), view(&seen), plane(image_plane(seen)), size(pixels) {}
};

/// Triangles of a list of primitives, and for each the place of its primitive in the list.
struct SnappedTriangles {
    std::vector<FixedTriangle> triangles;
    std::vector<std::uint32_t> place;

    void clear() {
        triangles.clear();
        place.clear();
    }
};

/// Appends what append_image_triangle and snap_triangle make of the primitives, in the order of the list, bit for bit:
/// a block of them at a time in vectors (AVX2 where `best_vectors` and the machine has it), and one by one those that
/// are cut by the view's border or seen nearly edge-on. Places count from `first_place`.
void snap_primitives(const ImageOf& image, std::span<const std::uint32_t> primitives, std::uint32_t first_place,
                     bool best_vectors, SnappedTriangles& out);

}  // namespace sightline
