// How many cells a line crosses: what it costs to walk through a tessellation (the stabbing number of TVCG 3.1).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/scene/view.h"
#include "core/space/cell_complex.h"

namespace sightline {

/// The cells whose inside the segment from `from` to `to` crosses, in their order along it; empty where it misses the
/// tessellation. Walks from facet to facet with exact tests. Nothing when it meets an edge or a corner of a facet (in
/// 2D an end of one), where neighbours do not tell which way to go.
template <int D>
std::optional<std::vector<std::uint32_t>> cells_along(const CellComplex<D>& cells, const Vec<D>& from,
                                                      const Vec<D>& to);

struct Stabbing {
    double mean = 0;         ///< cells a line crosses; 0 without lines
    std::uint32_t most = 0;  ///< the largest of them: a lower bound of the stabbing number, which is that of all lines
    std::uint32_t lines = 0;
};

/// Of `lines` random lines that meet the tessellation, each line about as likely as any other: uniform in direction and
/// in distance from the middle.
template <int D>
Stabbing random_lines(const CellComplex<D>& cells, std::uint32_t lines, std::uint64_t seed = 1);

/// Of `rays` random rays of each view, from its eye to the border of the tessellation; those that miss it are left out.
template <int D>
Stabbing eye_rays(const CellComplex<D>& cells, std::span<const View<D>> views, std::uint32_t rays,
                  std::uint64_t seed = 1);

}  // namespace sightline
