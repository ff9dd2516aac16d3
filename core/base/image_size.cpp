// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/image_size.h"

#include <algorithm>

namespace sightline {

template <>
ImageSize image_size<2>(const ImageSize& asked) {
    return {asked.width == 0 ? 8192 : asked.width, 1};
}

template <>
ImageSize image_size<3>(const ImageSize& asked) {
    if (asked.width == 0) return {1024, 768};
    // A width alone has the aspect of the default; more than an image can have is cut.
    const int width = std::min(asked.width, 8192);
    return {width, asked.height > 0 ? asked.height : std::max(1, width * 3 / 4)};
}

std::string image_size_text(const ImageSize& size) {
    return std::to_string(size.width) + (size.height > 0 ? "x" + std::to_string(size.height) : "");
}

}  // namespace sightline
