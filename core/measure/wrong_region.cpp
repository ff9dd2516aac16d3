// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/wrong_region.h"

#include <algorithm>

namespace sightline {

std::vector<std::uint8_t> wrong_mask(const IdImage& exact, std::span<const std::uint8_t> rendered) {
    std::vector<std::uint8_t> mask(exact.ids.size());
    std::transform(exact.ids.begin(), exact.ids.end(), mask.begin(),
                   [&](std::uint32_t id) { return static_cast<std::uint8_t>(id != none && !rendered[id]); });
    return mask;
}

std::size_t largest_region(std::span<const std::uint8_t> mask, int width, int height) {
    std::vector<std::uint8_t> left(mask.begin(), mask.end());
    std::vector<std::uint32_t> waiting;
    const auto w = static_cast<std::uint32_t>(width), h = static_cast<std::uint32_t>(height);
    std::size_t largest = 0;
    const auto take = [&](std::uint32_t pixel) {
        if (!left[pixel]) return;
        left[pixel] = 0;
        waiting.push_back(pixel);
    };
    for (std::uint32_t first = 0; first < left.size(); ++first) {
        std::size_t size = 0;
        take(first);
        while (!waiting.empty()) {
            const std::uint32_t pixel = waiting.back(), x = pixel % w, y = pixel / w;
            waiting.pop_back();
            ++size;
            if (x > 0) take(pixel - 1);
            if (x + 1 < w) take(pixel + 1);
            if (y > 0) take(pixel - w);
            if (y + 1 < h) take(pixel + w);
        }
        largest = std::max(largest, size);
    }
    return largest;
}

}  // namespace sightline
