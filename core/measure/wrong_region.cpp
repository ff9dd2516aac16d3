// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/wrong_region.h"

#include <algorithm>

namespace sightline {

namespace {

/// Calls `use(pixels)` for each region of ones that hang together by their sides, in the order of their first pixel.
template <typename Use>
void each_region(std::span<const std::uint8_t> mask, int width, int height, const Use& use) {
    std::vector<std::uint8_t> left(mask.begin(), mask.end());
    std::vector<std::uint32_t> region;
    const auto w = static_cast<std::uint32_t>(width), h = static_cast<std::uint32_t>(height);
    const auto take = [&](std::uint32_t pixel) {
        if (!left[pixel]) return;
        left[pixel] = 0;
        region.push_back(pixel);
    };
    for (std::uint32_t first = 0; first < left.size(); ++first) {
        region.clear();
        take(first);
        for (std::size_t next = 0; next < region.size(); ++next) {
            const std::uint32_t pixel = region[next], x = pixel % w, y = pixel / w;
            if (x > 0) take(pixel - 1);
            if (x + 1 < w) take(pixel + 1);
            if (y > 0) take(pixel - w);
            if (y + 1 < h) take(pixel + w);
        }
        if (!region.empty()) use(std::span<const std::uint32_t>(region));
    }
}

/// What the image shows at these pixels.
std::vector<PixelCount> owners(const IdImage& exact, std::span<const std::uint32_t> pixels) {
    std::vector<std::uint32_t> ids;
    for (const std::uint32_t pixel : pixels) ids.push_back(exact.ids[pixel]);
    std::sort(ids.begin(), ids.end());
    std::vector<PixelCount> counts;
    for (const std::uint32_t id : ids) {
        if (counts.empty() || counts.back().primitive != id) counts.push_back({id, 0});
        ++counts.back().pixels;
    }
    std::stable_sort(counts.begin(), counts.end(),
                     [](const PixelCount& a, const PixelCount& b) { return a.pixels > b.pixels; });
    return counts;
}

}  // namespace

std::vector<std::uint8_t> wrong_mask(const IdImage& exact, std::span<const std::uint8_t> rendered) {
    std::vector<std::uint8_t> mask(exact.ids.size());
    std::transform(exact.ids.begin(), exact.ids.end(), mask.begin(),
                   [&](std::uint32_t id) { return static_cast<std::uint8_t>(id != none && !rendered[id]); });
    return mask;
}

std::size_t largest_region(std::span<const std::uint8_t> mask, int width, int height) {
    std::size_t largest = 0;
    each_region(mask, width, height, [&](auto pixels) { largest = std::max(largest, pixels.size()); });
    return largest;
}

std::vector<WrongRegion> wrong_regions(const IdImage& exact, std::span<const std::uint8_t> wrong) {
    std::vector<WrongRegion> regions;
    each_region(wrong, exact.width, exact.height, [&](std::span<const std::uint32_t> pixels) {
        WrongRegion region{static_cast<std::uint32_t>(pixels.size()), {exact.width, 0, exact.height, 0}, {}};
        for (const std::uint32_t pixel : pixels) {
            const int x = static_cast<int>(pixel) % exact.width, y = static_cast<int>(pixel) / exact.width;
            region.box = {std::min(region.box[0], x), std::max(region.box[1], x), std::min(region.box[2], y),
                          std::max(region.box[3], y)};
        }
        region.primitives = owners(exact, pixels);
        regions.push_back(std::move(region));
    });
    std::stable_sort(regions.begin(), regions.end(),
                     [](const WrongRegion& a, const WrongRegion& b) { return a.pixels > b.pixels; });
    return regions;
}

}  // namespace sightline
