// How large a figure is put down.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sightline {

/// Final size: a width in millimetres (the height follows from the content), or the whole picture in pixels.
struct FigureSize {
    double width_mm = 84;
    int width_px = 0, height_px = 0;  ///< both > 0: the picture has exactly this many pixels (PDF, SVG: 1/96 inch)
    double font_pt = 8;               ///< size of legend, caption, titles and labels of scale 1
    unsigned columns = 0;             ///< of the panels; 0: as many as make good use of the page
    double dpi = 300;                 ///< PNG with a width in millimetres; images in SVG and PDF
};

}  // namespace sightline
