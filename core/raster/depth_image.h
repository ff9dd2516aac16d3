// Depth images: what is nearest at each pixel, drawn without OpenGL.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/raster/image_triangles.h"

namespace sightline {

/// Rows from the top. The sample of a pixel is its centre.
struct DepthImage {
    int width = 0, height = 0;
    std::vector<float> nearness;     ///< as of ImageCorner; 0: nothing is there
    std::vector<std::uint32_t> ids;  ///< none: nothing

    DepthImage() = default;
    explicit DepthImage(const ImageSize& size);
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    ImageSize size() const { return {width, height}; }
    bool operator==(const DepthImage&) const = default;
};

/// How a task is worked on. The result never depends on it.
struct RasterWork {
    int threads = 0;           ///< 0: as many as the machine has
    bool best_vectors = true;  ///< AVX2 where the machine has it; off: what every x86-64 has
};

/// Draws primitives over what is there already, in any order: all of the scene, or those of the list. Of those that
/// cover a pixel's centre the nearest is seen, of equally near ones that of the lowest id. Primitives that turn their
/// back on the eye are not drawn. Coverage is exact for corners on a grid of 256 places a pixel, and depths are those
/// of the snapped triangles, rounded to floats; so an image differs from exact arithmetic only within 1/128 pixel of an
/// edge, or where depths differ by less than floats tell.
void draw_depth(DepthImage& image, const Scene<3>& scene, const View<3>& view, const RasterWork& work = {});
void draw_depth(DepthImage& image, const Scene<3>& scene, const View<3>& view,
                std::span<const std::uint32_t> primitives, const RasterWork& work = {});

/// Image 0 has the nearest primitive of each pixel, image i the one that lies behind those of the images before it: at
/// most `layers` (1 to 64), fewer when an image is empty; image 0 always is there.
std::vector<DepthImage> draw_layers(const Scene<3>& scene, const View<3>& view, const ImageSize& size, int layers,
                                    const RasterWork& work = {});

/// Draws occluders into the depths alone, conservatively: a pixel counts as covered where the whole of its square lies
/// inside one triangle, and then is as far as that triangle's farthest point there.
void draw_occluders(DepthImage& image, const Scene<3>& scene, const View<3>& view,
                    std::span<const std::uint32_t> primitives, const RasterWork& work = {});

}  // namespace sightline
