// PNG and PDF through cairo.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "shell/figure/cairo_surface.h"
#include "shell/figure/canvas.h"
#include "shell/figure/font.h"

namespace sightline {

class CairoCanvas final : public Canvas {
public:
    /// Draws on the surface, which has `scale` of its units to the point; images have `px_per_pt` pixels to it. Throws
    /// WorkError when the surface is unusable.
    CairoCanvas(cairo_surface_t* surface, double scale, double px_per_pt, const Font& font);

    void clip(const Rect& rect) override;
    void unclip() override;
    void draw(const Path& path, const Pen& pen) override;
    void circle(const Vec<2>& centre, double radius, const Pen& pen) override;
    void gradient(const Rect& rect, std::span<const Colour> stops) override;
    void image(const Rect& rect, const DrawImage& draw) override;
    void text(const TextRun& run, const Colour& colour, const Colour& halo) override;

    void end_page();

private:
    void fill_and_stroke(const Pen& pen);

    const Font& font_;
    double px_per_pt_;
    std::unique_ptr<cairo_t, CairoDestroy> cairo_;
};

}  // namespace sightline
