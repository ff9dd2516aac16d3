// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/band.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "core/base/error.h"
#include "core/base/image_size.h"
#include "core/base/workers.h"
#include "core/raster/snap_primitives.h"

namespace sightline {

namespace {

constexpr std::size_t primitives_at_once = 8192;

}  // namespace

void sort_into_bands(BandedTriangles& part, const ImageSize& size) {
    part.of_band.resize(static_cast<std::size_t>(bands_of(size)));
    for (auto& band : part.of_band) band.clear();
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
        const PixelBox box(part.triangles[i], size);
        for (int band = box.top / band_rows; band <= (box.bottom - 1) / band_rows; ++band)
            part.of_band[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(i));
    }
}

void for_bands(const Scene<3>& scene, const View<3>& view, const ImageSize& size, bool all,
               std::span<const std::uint32_t> primitives, const RasterWork& work, const DrawBand& draw_band) {
    if (size.width < 1 || size.height < 1 || size.width > largest_raster || size.height > largest_raster)
        throw WorkError("an image of " + image_size_text(size) + " pixels: the rasteriser draws 1 to " +
                        std::to_string(largest_raster) + " a side");
    const ImageOf image(scene, view, size);
    const std::size_t count = all ? scene.primitives.size() : primitives.size();
    std::vector<BandedTriangles> parts((count + primitives_at_once - 1) / primitives_at_once);
    run_parts(static_cast<int>(parts.size()), work.threads, [&](int index) {
        BandedTriangles& part = parts[static_cast<std::size_t>(index)];
        const std::size_t begin = static_cast<std::size_t>(index) * primitives_at_once;
        const std::size_t part_size = std::min(count - begin, primitives_at_once);
        SnappedTriangles snapped;
        if (all) {
            std::vector<std::uint32_t> ids(part_size);
            std::iota(ids.begin(), ids.end(), static_cast<std::uint32_t>(begin));
            snap_primitives(image, ids, 0, work.best_vectors, snapped);
        } else {
            snap_primitives(image, primitives.subspan(begin, part_size), 0, work.best_vectors, snapped);
        }
        part.triangles = std::move(snapped.triangles);
        sort_into_bands(part, size);
    });
    run_parts(bands_of(size), work.threads, [&](int band) {
        draw_band(band * band_rows, std::min((band + 1) * band_rows, size.height), band, parts);
    });
}

}  // namespace sightline
