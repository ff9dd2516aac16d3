// A cairo image as a PNG that knows its resolution.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

using cairo_surface_t = struct _cairo_surface;

namespace sightline {

/// The file's bytes. The resolution is written down (pHYs), so that LaTeX and word processors place it at its size.
std::string encode_png(cairo_surface_t* surface, double dpi);

}  // namespace sightline
