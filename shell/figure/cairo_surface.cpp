// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/cairo_surface.h"

#include <cairo.h>

#include <string>

#include "core/base/error.h"

namespace sightline {

void CairoDestroy::operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
void CairoDestroy::operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

CairoSurface image_of(const Pixels& pixels) {
    CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width, pixels.height));
    if (const cairo_status_t status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
        throw WorkError(std::string("cannot hold an image: ") + cairo_status_to_string(status));
    unsigned char* data = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = 0; y < pixels.height; ++y) {
        auto* row = reinterpret_cast<std::uint32_t*>(data + std::ptrdiff_t{stride} * y);
        for (int x = 0; x < pixels.width; ++x) {
            const Colour& c = pixels.at(x, y);
            row[x] = std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | c.b;
        }
    }
    cairo_surface_mark_dirty(surface.get());
    return surface;
}

}  // namespace sightline
