// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/wrong_picture.h"

#include "core/traversal/state.h"

namespace sightline {

Pixels wrong_picture(const Reference& reference, std::span<const std::uint32_t> touched) {
    constexpr Colour right{255, 255, 255}, wrong{214, 39, 40};
    std::vector<std::uint8_t> rendered(reference.visible.size(), 0);
    for (const std::uint32_t entry : touched)
        if (!(entry & State<3>::culled_bit)) rendered[entry] = 1;
    Pixels picture{reference.image.width, reference.image.height, {}};
    picture.colours.reserve(reference.image.ids.size());
    for (const std::uint32_t id : reference.image.ids)
        picture.colours.push_back(id == no_primitive || rendered[id] ? right : wrong);
    return picture;
}

}  // namespace sightline
