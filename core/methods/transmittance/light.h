// Light from the eye: how much of it comes into a cell through its facets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "core/methods/transmittance/opacity.h"
#include "core/run/marks.h"
#include "core/run/problem.h"

namespace sightline {

/// A facet as a cell sees it, relative to CellLight::origin and in its unit.
template <int D>
struct LitFacet {
    std::array<float, D> centroid{};
    std::array<float, D> out{};  ///< a vector out of the cell, as long as the facet's area (2D: length)
};

/// What all views of a scene share.
template <int D>
struct CellLight {
    Vec<D> origin{};
    double unit = 1;                    ///< a power of 2 near the size of the tessellation
    std::vector<LitFacet<D>> facets{};  ///< as CellComplex::half_facets
    std::vector<Vec<D>> centres{};      ///< CellComplex::centre() of each cell, in one place
    CellOpacity<D> opacity{};
    double usual_size = 1;  ///< nine primitives in ten are no larger: square root of the area, 2D: length

    CellLight() = default;
    CellLight(const Scene<D>& scene, const CellComplex<D>& cells, int threads);
};

/// Made once for the cells of the problem.
template <int D>
std::shared_ptr<const CellLight<D>> cell_light(const Problem<D>& problem);

/// The size of a primitive: square root of its area, 2D: its length.
double primitive_size(const Primitive<2>& segment);
double primitive_size(const Primitive<3>& triangle);

/// The angle that a facet fills for an eye at `eye` (relative, as LitFacet), for a small one: radians, 3D: steradians;
/// 0 where it does not turn its outer side to the eye.
template <int D>
double angle_of(const LitFacet<D>& facet, const Vec<D>& eye) {
    double along = 0, squared = 0;
    for (int i = 0; i < D; ++i) {
        const double away = facet.centroid[static_cast<std::size_t>(i)] - eye[i];
        along -= facet.out[static_cast<std::size_t>(i)] * away;
        squared += away * away;
    }
    if (!(along > 0)) return 0;
    return D == 2 ? along / squared : along / (squared * std::sqrt(squared));
}

}  // namespace sightline
