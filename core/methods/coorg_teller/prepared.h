// What the family knows of a scene before the first view: polygons, a tree over them, and who may hide what from where.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/methods/coorg_teller/object_space_parameters.h"
#include "core/run/problem.h"
#include "core/space/polygons.h"
#include "core/space/reference_tree.h"

namespace sightline {

/// CT 3.3 and figure 8c, with one change: a polygon stands at the largest nodes that are no larger than its region, not
/// at all leaves below them, so that it stands in few places however fine the tree is. What an eye finds on the way
/// from the root to its leaf is the same and a little more; the area-angle decides.
template <int D>
struct Prepared {
    Polygons<D> polygons;
    ReferenceTree<D> tree;
    double threshold = 0;
    std::vector<std::uint32_t> region_begin{0};  ///< of each node of tree.space
    std::vector<std::uint32_t> region_polygons;
    double milliseconds_polygons = 0, milliseconds_tree = 0, milliseconds_regions = 0;

    /// Polygons that may have an area-angle of at least the threshold at the eye: no other one has.
    std::vector<std::uint32_t> near(const Vec<D>& eye) const;
    /// Distinct polygons at the leaves, added up (table 1, "Final").
    std::size_t polygon_references() const;
};

template <int D>
Prepared<D> prepare(const Scene<D>& scene, TreeKind kind, std::uint32_t leaf, double threshold);

/// As the problem's parameters ask, made once for its scene.
template <int D>
std::shared_ptr<const Prepared<D>> prepared(const Problem<D>& problem);

/// The least side of a node, as a share of the scene's longest one: leaves of a floor of 90 m may be 20 cm.
inline constexpr double least_node_side = 1.0 / 512;

}  // namespace sightline
