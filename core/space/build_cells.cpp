// The cells that the settings ask for, from any of the builders.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/builders.h"
#include "core/space/merge_alike.h"

namespace sightline {

template <int D>
CellComplex<D> tessellation(const Scene<D>& scene, const TessellationSettings& settings) {
    const auto tree = [&](const auto& build) {
        Tree<D> made = build(scene.primitives, settings.error_bound, settings.leaf_capacity);
        if (settings.split_for == SplitFor::opacity)
            made = merge_alike<D>(made, scene.primitives, settings.opacity_tolerance);
        return made;
    };
    if (settings.tessellation == Tessellation::kd) return kd_cells(tree(build_kd_tree<D>), settings.neighbours);
    if (settings.tessellation == Tessellation::tree) return tree_cells(tree(build_tree<D>), settings.neighbours);
    return delaunay_cells(tree(build_tree<D>), settings);
}

template <int D>
CellComplex<D> build_cells(const Scene<D>& scene, const TessellationSettings& settings) {
    CellComplex<D> cells = tessellation(scene, settings);
    assign_primitives(cells, scene.primitives);
    return cells;
}

template CellComplex<2> tessellation<2>(const Scene<2>&, const TessellationSettings&);
template CellComplex<3> tessellation<3>(const Scene<3>&, const TessellationSettings&);
template CellComplex<2> build_cells<2>(const Scene<2>&, const TessellationSettings&);
template CellComplex<3> build_cells<3>(const Scene<3>&, const TessellationSettings&);

}  // namespace sightline
