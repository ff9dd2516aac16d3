// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/raster/band.h"
#include "core/raster/depth_image.h"
#include "core/scene/view.h"

namespace sightline {

namespace {

/// Places between the true edges and the shrunk ones: more than snapping moves them.
constexpr int shrink_margin = 2;

void draw_inside(DepthImage& image, const FixedTriangle& triangle, int first_row, int end_row) {
    const CoveredRows rows(triangle, image.size(), true, shrink_margin);
    const NearnessPlane plane(triangle);
    // The farthest point of a pixel's square lies in a corner of it; snapping moves the plane by less than a 128th
    // of a pixel's slope more.
    const double back = plane.half_pixel() * (1 + 2.0 / 128);
    for (std::int32_t y = std::max(rows.first_row, first_row); y < std::min(rows.end_row, end_row); ++y) {
        std::int32_t first, end;
        rows.span(y, first, end);
        const NearnessPlane::Row row = plane.row(y, std::max(first, 0));
        for (std::int32_t x = first; x < end; ++x) {
            // A step towards 0 for what rounding may add.
            const float farthest = std::nextafter(static_cast<float>(row.at(x - first) - back), 0.0f);
            float& here = image.nearness[image.index(x, y)];
            here = std::max(here, farthest);
        }
    }
}

}  // namespace

void draw_occluders(DepthImage& image, const Scene<3>& scene, const View<3>& view,
                    std::span<const std::uint32_t> primitives, const RasterWork& work) {
    for_bands(scene, view, image.size(), false, primitives, work,
              [&](int first_row, int end_row, int band, std::span<const BandedTriangles> parts) {
                  for (const BandedTriangles& part : parts)
                      for (const std::uint32_t index : part.of_band[static_cast<std::size_t>(band)])
                          draw_inside(image, part.triangles[index], first_row, end_row);
              });
}

}  // namespace sightline
