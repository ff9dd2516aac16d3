// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/wrong_picture.h"

namespace sightline {

Pixels wrong_picture(const Reference& reference, std::span<const Met> met) {
    constexpr Colour right{255, 255, 255}, wrong{255, 0, 0};
    const std::vector<std::uint8_t> rendered = rendered_mask(met, reference.visible.size());
    Pixels pixels{reference.image.width, reference.image.height, {}};
    pixels.colours.reserve(reference.image.ids.size());
    for (const std::uint32_t id : reference.image.ids)
        pixels.colours.push_back(id == none || rendered[id] ? right : wrong);
    return pixels;
}

}  // namespace sightline
