// What painting asks of a format. Coordinates are points of the page, y down.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "core/draw/pixels.h"
#include "shell/figure/page.h"

namespace sightline {

/// Makes an opaque image of so many pixels, of which `px_per_pt` make a point.
using DrawImage = std::function<Pixels(int width, int height, double px_per_pt)>;

class Canvas {
public:
    virtual ~Canvas() = default;
    /// Until unclip(), only what lies in the rectangle shows. Not nested.
    virtual void clip(const Rect& rect) = 0;
    virtual void unclip() = 0;
    /// Fills, then strokes. Runs of one point repeated twice are round dots.
    virtual void draw(const Path& path, const Pen& pen) = 0;
    virtual void circle(const Vec<2>& centre, double radius, const Pen& pen) = 0;
    /// Colours evenly spread from left to right.
    virtual void gradient(const Rect& rect, std::span<const Colour> stops) = 0;
    /// Fills the rectangle, to the nearest pixel, with an image of as many pixels as the format has there, at most
    /// largest_solid_picture a side.
    virtual void image(const Rect& rect, const DrawImage& draw) = 0;
    /// A halo with a > 0 is drawn 1 pt around the glyphs.
    virtual void text(const TextRun& run, const Colour& colour, const Colour& halo = transparent) = 0;
};

}  // namespace sightline
