// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/reference.h"

namespace sightline {

std::vector<std::uint32_t> layering_numbers(std::span<const IdImage> layers, std::size_t primitive_count) {
    std::vector<std::uint32_t> numbers(primitive_count, 0);
    for (std::size_t layer = layers.size(); layer-- > 0;)
        for (const std::uint32_t id : layers[layer].ids)
            if (id != none) numbers[id] = static_cast<std::uint32_t>(layer + 1);
    return numbers;
}

}  // namespace sightline
