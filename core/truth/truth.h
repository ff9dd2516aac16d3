// What is really visible, made in one place for both dimensions: the exact set, an exact image and the layering
// numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/run/problem.h"
#include "core/truth/id_image.h"
#include "core/truth/reference.h"

namespace sightline {

// 3D: `draw_ids` draws the images, where it is empty core's own rasteriser, and `up_axis` of the scene is that of the
// view.

/// The exact visible set; 3D: from an image of that size.
template <int D>
std::vector<std::uint8_t> visible_set(const Scene<D>& scene, const View<D>& view, const ImageSize& size,
                                      const DrawIds& draw_ids);

/// With the exact visible set of a view: made when it is first asked for, and kept. The scene outlives it.
template <int D>
Services exact_services(const Scene<D>& scene, const View<D>& view, const ImageSize& size, const DrawIds& draw_ids);
/// With one that is known.
Services known_services(std::shared_ptr<const std::vector<std::uint8_t>> visible, const ImageSize& size);

/// The set, what of it lies in which cell, and the image; in 2D that is item_row, while V is the exact set, so that a
/// primitive may be visible and own no pixel.
template <int D>
Reference make_reference(const Scene<D>& scene, const CellComplex<D>& cells, const View<D>& view, const ImageSize& size,
                         const DrawIds& draw_ids);

/// Layering numbers ζ; 0: unknown or hit by no ray.
template <int D>
std::vector<std::uint32_t> make_layering(const Scene<D>& scene, const View<D>& view, const ImageSize& size,
                                         const DrawIds& draw_ids);

/// The item buffer of the papers in 2D: an image of one row. An all-round view has four image lines of equal width.
IdImage item_row(const Scene<2>& scene, const View<2>& view, const ImageSize& size);

/// Per primitive, how many pixels of the image show it.
std::vector<std::uint32_t> pixels_of(const IdImage& image, std::size_t primitive_count);

struct Truth {
    Reference reference;
    std::shared_ptr<const std::vector<std::uint32_t>> zeta;  ///< per primitive
    /// fused_share (hiding.h); 3D: of what the first layers show. NaN: nothing is hidden, or it was not asked for.
    double fused = std::numeric_limits<double>::quiet_NaN();
};

/// One per tessellation; what does not depend on cells is made once. `with_zeta`: false leaves out what needs more
/// than the nearest primitive, the layering numbers, all 0, and `fused`, which is quicker.
template <int D>
std::vector<Truth> make_truths(const Scene<D>& scene, std::span<const CellComplex<D>* const> tessellations,
                               const View<D>& view, const ImageSize& size, const DrawIds& draw_ids,
                               bool with_zeta = true);

}  // namespace sightline
