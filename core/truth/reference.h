// What is really visible, per primitive and per cell: the yardstick of every metric.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/space/cell_complex.h"
#include "core/truth/id_image.h"
#include "core/truth/visible_set.h"

namespace sightline {

struct Reference {
    std::string name;                   ///< "exact", "item buffer WxH" or "software item buffer WxH"
    std::vector<std::uint8_t> visible;  ///< per primitive
    std::size_t count = 0;              ///< |V|
    /// Per cell: the part of the visible angle (2D) or pixels (3D) that lies inside it; 0: hidden. A piece on the
    /// border of two cells counts in both.
    std::vector<double> cell_share;
    std::size_t eye_on = 0;               ///< primitives that contain the eye (visible_set.h)
    std::vector<VisiblePiece> pieces{};   ///< 2D
    IdImage image{};                      ///< the exact image; 2D: one row
    std::vector<std::uint32_t> pixels{};  ///< per primitive: how many pixels of the image show it
};

/// The exact reference in 2D.
Reference exact_reference(const std::vector<Primitive<2>>& primitives, const CellComplex<2>& cells,
                          const View<2>& view);

/// Where the ray through a pixel's centre meets the image plane through look_at; rows from the top.
Vec<3> pixel_centre(const View<3>& view, const ImageSize& size, int x, int y);

/// The reference in 3D from the image that `view` sees. A pixel lies in the cell that holds the point seen through its
/// centre.
Reference image_reference(IdImage image, const Scene<3>& scene, const CellComplex<3>& cells, const View<3>& view);

/// How many images DrawIds makes for layering numbers.
inline constexpr int most_layers = 8;

/// Layering number of every primitive (TVCG section 3) as far as images of layers tell: the number, from 1, of the
/// first one that shows it; 0 where none does.
std::vector<std::uint32_t> layering_numbers(std::span<const IdImage> layers, std::size_t primitive_count);

}  // namespace sightline
