// What a frame is measured against, in both dimensions: the exact set, an exact image and the layering numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/truth/id_image.h"
#include "core/truth/reference.h"

namespace sightline {

struct Truth {
    /// In 2D too with an image, of one row: the item buffer of the papers' reference. 2D: V is the exact set, so that a
    /// primitive may be visible and own no pixel.
    Reference reference;
    std::shared_ptr<const std::vector<std::uint32_t>> zeta;  ///< per primitive; 0: unknown or hit by no ray
};

/// One per tessellation; what does not depend on cells is made once. 3D: `draw_ids` draws the images and `up_axis` of
/// the scene is that of the view. `with_zeta`: false leaves the layering numbers out, all 0, which is quicker. Throws
/// WorkError where there is no OpenGL.
template <int D>
std::vector<Truth> make_truths(const Scene<D>& scene, std::span<const CellComplex<D>* const> tessellations,
                               const View<D>& view, const ImageSize& size, const DrawIds& draw_ids,
                               bool with_zeta = true);

}  // namespace sightline
