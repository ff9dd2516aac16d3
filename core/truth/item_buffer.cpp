// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/item_buffer.h"

#include "core/raster/pixel_line.h"

namespace sightline {

ItemBuffer item_buffer(std::span<const Primitive<2>> primitives, const View<2>& view, int width) {
    PixelLine line(view, width);
    draw_line(line, primitives, view);
    return {std::move(line.ids)};
}

std::vector<std::uint8_t> visible_in(const ItemBuffer& buffer, std::size_t primitive_count) {
    std::vector<std::uint8_t> visible(primitive_count, 0);
    for (const std::uint32_t id : buffer.ids)
        if (id != none) visible[id] = 1;
    return visible;
}

}  // namespace sightline
