// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/depth_image.h"

#include <algorithm>

#include "core/base/index.h"
#include "core/raster/band.h"
#include "core/scene/view.h"

namespace sightline {

namespace {

void draw_bands(DepthImage& image, const Scene<3>& scene, const View<3>& view, bool all,
                std::span<const std::uint32_t> primitives, const RasterWork& work) {
    for_bands(scene, view, image.size(), all, primitives, work,
              [&](int first_row, int end_row, int band, std::span<const BandedTriangles> parts) {
                  const BandPixels pixels{image.size(), first_row, end_row, image.nearness.data(), image.ids.data()};
                  for (const BandedTriangles& part : parts)
                      fill_band(pixels, part.triangles, part.of_band[static_cast<std::size_t>(band)],
                                work.best_vectors);
              });
}

}  // namespace

DepthImage::DepthImage(const ImageSize& size) : width(size.width), height(size.height) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    nearness.assign(count, 0);
    ids.assign(count, none);
}

void draw_depth(DepthImage& image, const Scene<3>& scene, const View<3>& view, const RasterWork& work) {
    draw_bands(image, scene, view, true, {}, work);
}

void draw_depth(DepthImage& image, const Scene<3>& scene, const View<3>& view,
                std::span<const std::uint32_t> primitives, const RasterWork& work) {
    draw_bands(image, scene, view, false, primitives, work);
}

}  // namespace sightline
