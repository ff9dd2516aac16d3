// Hierarchical z: the farthest depth of blocks of pixels, and of blocks of blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/raster/depth_image.h"

namespace sightline {

/// Level 0 has blocks of 8 x 8 pixels; each block of a level has four of the level below, and the last level is one
/// block. What is nowhere nearer than the farthest of a block is hidden in all of it.
class DepthPyramid {
public:
    static constexpr int block = 8;
    struct Level {
        int width = 0, height = 0;  ///< in blocks
        std::vector<float> farthest{};
        float at(int x, int y) const {
            return farthest[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x)];
        }
    };

    DepthPyramid() = default;
    explicit DepthPyramid(const DepthImage& image);
    /// After pixels of some blocks have changed: indices into level 0. Blocks of which at least the share `opacity` is
    /// covered count as covered (Zhang et al. 1997); below 1 a pyramid does not tell what is hidden for sure.
    void update(const DepthImage& image, std::span<const std::uint32_t> blocks, double opacity = 1);

    std::vector<Level> levels;
};

}  // namespace sightline
