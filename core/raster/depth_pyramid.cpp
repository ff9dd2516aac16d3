// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/depth_pyramid.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace sightline {

namespace {

float farthest_pixel(const DepthImage& image, int block_x, int block_y) {
    constexpr int side = DepthPyramid::block;
    const int end_y = std::min((block_y + 1) * side, image.height);
    float farthest = std::numeric_limits<float>::infinity();
    if ((block_x + 1) * side <= image.width) {
        // Column by column, for the sake of vectors.
        std::array<float, side> columns;
        columns.fill(farthest);
        for (int y = block_y * side; y < end_y; ++y) {
            const float* const row = &image.nearness[image.index(block_x * side, y)];
            for (std::size_t i = 0; i < side; ++i) columns[i] = row[i] < columns[i] ? row[i] : columns[i];
        }
        return *std::min_element(columns.begin(), columns.end());
    }
    for (int y = block_y * side; y < end_y; ++y)
        for (int x = block_x * side; x < std::min((block_x + 1) * side, image.width); ++x)
            farthest = std::min(farthest, image.nearness[image.index(x, y)]);
    return farthest;
}

float farthest_covered(const DepthImage& image, int block_x, int block_y, double opacity) {
    constexpr int side = DepthPyramid::block;
    const int end_x = std::min((block_x + 1) * side, image.width), end_y = std::min((block_y + 1) * side, image.height);
    float farthest = std::numeric_limits<float>::infinity();
    int covered = 0;
    for (int y = block_y * side; y < end_y; ++y)
        for (int x = block_x * side; x < end_x; ++x)
            if (const float here = image.nearness[image.index(x, y)]; here > 0) {
                farthest = std::min(farthest, here);
                ++covered;
            }
    const int pixels = (end_x - block_x * side) * (end_y - block_y * side);
    return covered > 0 && covered >= opacity * pixels ? farthest : 0;
}

float farthest_below(const DepthPyramid::Level& below, int block_x, int block_y) {
    float farthest = std::numeric_limits<float>::infinity();
    for (int y = 2 * block_y; y < std::min(2 * block_y + 2, below.height); ++y)
        for (int x = 2 * block_x; x < std::min(2 * block_x + 2, below.width); ++x)
            farthest = std::min(farthest, below.at(x, y));
    return farthest;
}

int halved(int n, int by) { return (n + by - 1) / by; }

}  // namespace

DepthPyramid::DepthPyramid(const DepthImage& image) {
    int width = halved(image.width, block), height = halved(image.height, block);
    while (true) {
        levels.push_back({width, height, {}});
        levels.back().farthest.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        if (width <= 1 && height <= 1) break;
        width = halved(width, 2);
        height = halved(height, 2);
    }
    std::vector<std::uint32_t> all(levels[0].farthest.size());
    std::iota(all.begin(), all.end(), 0u);
    update(image, all);
}

void DepthPyramid::update(const DepthImage& image, std::span<const std::uint32_t> blocks, double opacity) {
    if (blocks.empty()) return;
    // Blocks of a level, each maybe more than once, whose farthest depth has changed.
    std::vector<std::uint32_t> changed, above;
    const auto set = [&](Level& level, std::uint32_t at, float farthest) {
        if (level.farthest[at] == farthest) return;
        level.farthest[at] = farthest;
        changed.push_back(at);
    };
    for (const std::uint32_t at : blocks) {
        const int x = static_cast<int>(at) % levels[0].width, y = static_cast<int>(at) / levels[0].width;
        set(levels[0], at, opacity < 1 ? farthest_covered(image, x, y, opacity) : farthest_pixel(image, x, y));
    }
    for (std::size_t i = 1; i < levels.size() && !changed.empty(); ++i) {
        above.swap(changed);
        changed.clear();
        const Level& below = levels[i - 1];
        for (const std::uint32_t at : above) {
            const int x = static_cast<int>(at) % below.width / 2, y = static_cast<int>(at) / below.width / 2;
            set(levels[i], static_cast<std::uint32_t>(y * levels[i].width + x), farthest_below(below, x, y));
        }
    }
}

}  // namespace sightline
