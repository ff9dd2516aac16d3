// The cells of the front drawn into one image of ids, as the gem tests them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster/item_image.h"
#include "core/run/screen.h"

namespace sightline {

template <int D>
struct FrontImage {
    std::vector<std::conditional_t<D == 2, LineShape, SeenShape>> shapes;  ///< of the cells, in their order
    std::vector<std::uint32_t> owners;  ///< per pixel: the place of the cell that it shows, or none
};

/// Drawn in their order, where they lie before what the screen shows. Its pyramid must show all that is drawn.
template <int D>
FrontImage<D> draw_front(const Problem<D>& problem, const Screen<D>& screen, std::span<const std::uint32_t> cells,
                         ItemWins wins);

/// The tiles of images that decide.
template <int D>
TileGrid screen_tiles(const Problem<D>& problem);

}  // namespace sightline
