// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/wrong_picture.h"

#include "core/traversal/state.h"

namespace sightline {

Pixels wrong_picture(const Reference& reference, std::span<const std::uint32_t> touched) {
    constexpr Colour right{255, 255, 255}, wrong{255, 0, 0};
    std::vector<bool> rendered(reference.visible.size(), false);
    for (const std::uint32_t entry : touched)
        if (!(entry & State<3>::culled_bit)) rendered[entry] = true;
    Pixels pixels{reference.image.width, reference.image.height, {}};
    pixels.colours.reserve(reference.image.ids.size());
    for (const std::uint32_t id : reference.image.ids)
        pixels.colours.push_back(id == no_primitive || rendered[id] ? right : wrong);
    return pixels;
}

}  // namespace sightline
