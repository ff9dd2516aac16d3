// Owners of cairo's objects, and pixels as a cairo image.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/draw/pixels.h"

using cairo_t = struct _cairo;
using cairo_surface_t = struct _cairo_surface;

namespace sightline {

struct CairoDestroy {
    void operator()(cairo_t* cairo) const;
    void operator()(cairo_surface_t* surface) const;
};
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDestroy>;

/// The pixels without their opacity. Throws WorkError when there is no memory for the image.
CairoSurface image_of(const Pixels& pixels);

}  // namespace sightline
