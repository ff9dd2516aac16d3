// Which polygons hide anything for one eye: the largest of those that are near enough.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/coorg_teller/prepared.h"

namespace sightline {

/// One of the potential occluders (CT 3.3).
struct Candidate {
    double area_angle = 0;  ///< absolute
    std::uint32_t polygon = none;
};

/// The first `count` polygons whose area-angle at the eye is at least the threshold, of which it sees a side, and which
/// meet the view: others hide nothing that is in it. Largest first, of equal ones the lower number.
template <int D>
std::vector<Candidate> potential_occluders(const Prepared<D>& prepared, const Scene<D>& scene, const View<D>& view,
                                           std::size_t count = none);

/// Of several occluders the polygons of each, ascending; the occluders largest first.
using OccluderLists = std::vector<std::vector<std::uint32_t>>;

/// Each for itself: the actual occluders of Coorg and Teller.
OccluderLists single_occluders(std::span<const Candidate> chosen);

/// Occluders as Hudson et al. 1997 have them, convex ones: from the largest polygon that is in none so far, across the
/// edges at which the eye sees both polygons, as long as no polygon reaches before the plane of another.
template <int D>
OccluderLists convex_occluders(const Prepared<D>& prepared, const Scene<D>& scene, const Vec<D>& eye,
                               std::span<const Candidate> potential, std::size_t count);

}  // namespace sightline
