// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cells/front_image.h"

namespace sightline {

template <>
FrontImage<2> draw_front<2>(const Problem<2>& problem, const Screen<2>& screen, std::span<const std::uint32_t> cells,
                            ItemWins wins) {
    const PixelLine& line = screen.image().image();
    FrontImage<2> front;
    for (const std::uint32_t cell : cells)
        front.shapes.push_back(seen_cell(problem.view, line.width(), *problem.cells, cell));
    front.owners = draw_items(front.shapes, line, wins);
    return front;
}

template <>
FrontImage<3> draw_front<3>(const Problem<3>& problem, const Screen<3>& screen, std::span<const std::uint32_t> cells,
                            ItemWins wins) {
    const DepthImage& image = screen.image().image();
    FrontImage<3> front;
    for (const std::uint32_t cell : cells)
        front.shapes.push_back(seen_cell(problem.view, image.size(), *problem.cells, cell));
    front.owners = draw_items(front.shapes, image, screen.image().pyramid(), wins);
    return front;
}

template <>
TileGrid screen_tiles<2>(const Problem<2>& problem) {
    return {pixels_of_line(problem.view, image_size<2>(problem.services.image).width), 1};
}
template <>
TileGrid screen_tiles<3>(const Problem<3>& problem) {
    const ImageSize size = image_size<3>(problem.services.image);
    return {size.width, size.height};
}

}  // namespace sightline
