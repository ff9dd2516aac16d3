// The size of a reference image.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sightline {

/// Pixels; 0: what the dimension asks for. 2D references have a width only.
struct ImageSize {
    int width = 0, height = 0;
    bool operator==(const ImageSize&) const = default;
};

/// The size that "auto" stands for, or the asked one: D = 2 width x 1, D = 3 width x height.
template <int D>
ImageSize image_size(const ImageSize& asked);
template <>
ImageSize image_size<2>(const ImageSize& asked);
template <>
ImageSize image_size<3>(const ImageSize& asked);

/// The same in words: "8192" or "1024x768".
std::string image_size_text(const ImageSize& size);

}  // namespace sightline
