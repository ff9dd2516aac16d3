// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/band.h"

#include <algorithm>

#include <string>

#include "core/base/error.h"
#include "core/base/image_size.h"
#include "core/raster/workers.h"

namespace sightline {

namespace {

constexpr std::size_t primitives_at_once = 8192;

int bands_of(const ImageSize& size) { return (size.height + band_rows - 1) / band_rows; }

}  // namespace

void for_bands(const Scene<3>& scene, const View<3>& view, const ImageSize& size, bool all,
               std::span<const std::uint32_t> primitives, const RasterWork& work, const DrawBand& draw_band) {
    if (size.width < 1 || size.height < 1 || size.width > largest_raster || size.height > largest_raster)
        throw WorkError("an image of " + image_size_text(size) + " pixels: the rasteriser draws 1 to " +
                        std::to_string(largest_raster) + " a side");
    const ImagePlane plane = image_plane(view);
    const std::size_t count = all ? scene.primitives.size() : primitives.size();
    std::vector<BandedTriangles> parts((count + primitives_at_once - 1) / primitives_at_once);
    run_parts(static_cast<int>(parts.size()), work.threads, [&](int index) {
        BandedTriangles& part = parts[static_cast<std::size_t>(index)];
        part.of_band.resize(static_cast<std::size_t>(bands_of(size)));
        std::vector<ImageCorner> corners;
        const std::size_t begin = static_cast<std::size_t>(index) * primitives_at_once;
        for (std::size_t i = begin; i < std::min(count, begin + primitives_at_once); ++i) {
            corners.clear();
            append_image_triangle(scene, view, plane, size, all ? i : primitives[i], corners);
            for (std::size_t k = 0; k < corners.size(); k += 3) {
                FixedTriangle triangle;
                if (!snap_triangle(&corners[k], size, triangle)) continue;
                const auto [top, bottom] = std::minmax({triangle.y[0], triangle.y[1], triangle.y[2]});
                const int first = std::max(first_centre(top), 0), end = std::min(first_centre(bottom), size.height);
                for (int band = first / band_rows; band <= (end - 1) / band_rows; ++band)
                    part.of_band[static_cast<std::size_t>(band)].push_back(
                        static_cast<std::uint32_t>(part.triangles.size()));
                part.triangles.push_back(triangle);
            }
        }
    });
    run_parts(bands_of(size), work.threads, [&](int band) {
        draw_band(band * band_rows, std::min((band + 1) * band_rows, size.height), band, parts);
    });
}

}  // namespace sightline
