// Images of ids drawn by core's own rasteriser: references without OpenGL.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/truth/id_image.h"
#include "core/truth/reference_by.h"

namespace sightline {

/// As DrawIds asks, the same on every machine. Differs from OpenGL's only in pixels within 1/128 pixel of an edge, or
/// where two depths are equal as far as floats tell.
std::vector<IdImage> draw_ids_in_software(const Scene<3>& scene, const View<3>& view, const ImageSize& size,
                                          int layers);

/// What draws the references that a person asks for: `opengl`, or the software where that is wanted or where there is
/// no OpenGL (an empty function).
DrawIds drawing_of(ReferenceBy by, const DrawIds& opengl);

}  // namespace sightline
