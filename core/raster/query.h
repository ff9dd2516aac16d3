// Occlusion queries: does any pixel of a shape lie before all that is drawn, how many do, and what covers the others.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/raster/depth_pyramid.h"
#include "core/raster/seen_shape.h"

namespace sightline {

struct Pixel {
    int x = 0, y = 0;
    bool operator==(const Pixel&) const = default;
};

// Conservative: a shape is hidden only where nothing that lies in it could change the image. Pixels where nothing is
// drawn show it.

/// A pixel that shows it, or nothing. Always the same one, though not the first.
std::optional<Pixel> find_seen(const SeenShape& shape, const DepthImage& image, const DepthPyramid& pyramid);

/// How many pixels show it.
std::uint32_t count_seen(const SeenShape& shape, const DepthImage& image, const DepthPyramid& pyramid);

/// Calls `each(x, y, shows)` for every pixel that the shape covers.
template <typename Each>
void for_covered(const SeenShape& shape, const DepthImage& image, Each each) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            bool covers = shape.everywhere, shows = shape.everywhere;
            for (const SeenFace& face : shape.faces)
                if (face.holds(x, y)) {
                    covers = true;
                    shows |= face.nearness(x, y) >= static_cast<double>(image.nearness[image.index(x, y)]);
                }
            if (covers) each(x, y, shows);
        }
}

struct ShapeSight {
    std::uint32_t pixels = 0;  ///< that it covers, seen or not
    std::uint32_t seen = 0;
    std::vector<std::uint32_t> hidden_by;  ///< ascending: the primitives at the others
};

/// Pixel by pixel, for those who ask why.
ShapeSight look_at(const SeenShape& shape, const DepthImage& image);

}  // namespace sightline
