// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/index.h"
#include "core/raster/band.h"
#include "core/raster/depth_image.h"
#include "core/scene/view.h"

namespace sightline {

namespace {

struct Seen {
    float nearness = 0;
    std::uint32_t id = none;
    bool before(const Seen& other) const {
        return nearness > other.nearness || (nearness == other.nearness && id < other.id);
    }
};

/// Puts it into the sorted layers of a pixel; the last falls out.
void insert(std::span<Seen> layers, const Seen& seen) {
    std::size_t at = layers.size();
    while (at > 0 && seen.before(layers[at - 1])) --at;
    if (at == layers.size()) return;
    std::move_backward(layers.begin() + static_cast<std::ptrdiff_t>(at), layers.end() - 1, layers.end());
    layers[at] = seen;
}

void draw_into(std::vector<Seen>& pixels, std::size_t layers, const BandPixels& band, const BandedTriangles& part,
               int index) {
    for (const std::uint32_t of : part.of_band[static_cast<std::size_t>(index)]) {
        const FixedTriangle& triangle = part.triangles[of];
        const CoveredRows rows(triangle, band.size);
        const NearnessPlane plane(triangle);
        const std::int32_t end_row = std::min(rows.end_row, band.end_row);
        for (std::int32_t y = std::max(rows.first_row, band.first_row); y < end_row; ++y) {
            std::int32_t first, end;
            rows.span(y, first, end);
            if (end <= first) continue;
            const NearnessPlane::Row row = plane.row(y, first);
            Seen* pixel =
                &pixels[(static_cast<std::size_t>(y - band.first_row) * static_cast<std::size_t>(band.size.width) +
                         static_cast<std::size_t>(first)) *
                        layers];
            for (std::int32_t i = 0; i < end - first; ++i, pixel += layers)
                insert({pixel, layers}, {static_cast<float>(row.at(i)), triangle.id});
        }
    }
}

}  // namespace

std::vector<DepthImage> draw_layers(const Scene<3>& scene, const View<3>& view, const ImageSize& size, int layers,
                                    const RasterWork& work) {
    std::vector<DepthImage> images(static_cast<std::size_t>(std::clamp(layers, 1, 64)), DepthImage(size));
    if (images.size() == 1) {
        draw_depth(images[0], scene, view, work);
        return images;
    }
    for_bands(scene, view, size, true, {}, work,
              [&](int first_row, int end_row, int band, std::span<const BandedTriangles> parts) {
                  const std::size_t begin = images[0].index(0, first_row), count = images[0].index(0, end_row) - begin;
                  std::vector<Seen> pixels(count * images.size());
                  for (const BandedTriangles& part : parts)
                      draw_into(pixels, images.size(), {size, first_row, end_row, nullptr, nullptr}, part, band);
                  for (std::size_t i = 0; i < pixels.size(); ++i) {
                      DepthImage& image = images[i % images.size()];
                      image.nearness[begin + i / images.size()] = pixels[i].nearness;
                      image.ids[begin + i / images.size()] = pixels[i].id;
                  }
              });
    const auto empty = [](const DepthImage& image) {
        return std::all_of(image.ids.begin(), image.ids.end(), [](auto id) { return id == none; });
    };
    while (images.size() > 1 && empty(images.back())) images.pop_back();
    return images;
}

}  // namespace sightline
