// What a run draws, held against the exact image, also where levels of detail stand in for objects.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/run/run.h"
#include "core/truth/reference.h"

namespace sightline {

/// Per pixel of the reference's image 1 where what the run has drawn so far shows something else. Without levels that
/// is what wrong_mask() says of what is rendered, and no image is drawn. With levels the image is drawn, by `draw_ids`
/// (3D; empty: in software), which should be what drew the reference, and compared by objects: a pixel is right where
/// both show a primitive of one object, or nothing.
template <int D>
std::vector<std::uint8_t> wrong_mask(const Reference& reference, const Run<D>& run, const DrawIds& draw_ids);

/// The share of ones in it.
template <int D>
double wrong_pixels(const Reference& reference, const Run<D>& run, const DrawIds& draw_ids);

/// |V ∩ T|, where a primitive whose object is drawn at a level counts as rendered.
template <int D>
std::size_t visible_found(const Reference& reference, const Run<D>& run);

}  // namespace sightline
