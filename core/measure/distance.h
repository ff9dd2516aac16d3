// Wrong pixels by how far from the eye they lie: what is far away costs few pixels and is seen least.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/measure/measure_table.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"
#include "core/truth/id_image.h"

namespace sightline {

/// Where a bin ends, as a share of the scene's longest side: 1/64, 1/32, … 1; the last one has no end. Each begins
/// where the one before it ends, the first at the eye.
double distance_bin_end(std::size_t bin);

/// The bin of what no pixel shows.
inline constexpr std::uint8_t no_bin = 255;

/// Per pixel of an exact image the bin of the point that it shows at its centre.
template <int D>
std::vector<std::uint8_t> distance_bins_of(const IdImage& image, const Scene<D>& scene, const View<D>& view);

/// Sets wrong_at and pixels_at. `bins` is distance_bins_of, `wrong` wrong_mask.
void count_distances(std::span<const std::uint8_t> bins, std::span<const std::uint8_t> wrong, Values& values);

}  // namespace sightline
