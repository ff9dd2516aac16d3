// PNG and PDF through cairo.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "shell/figure/canvas.h"
#include "shell/figure/font.h"

using cairo_t = struct _cairo;
using cairo_surface_t = struct _cairo_surface;

namespace sightline {

struct CairoDestroy {
    void operator()(cairo_t* cairo) const;
    void operator()(cairo_surface_t* surface) const;
};
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDestroy>;

class CairoCanvas final : public Canvas {
public:
    /// Draws on the surface, which has `scale` of its units to the point. Throws WorkError when it is unusable.
    CairoCanvas(cairo_surface_t* surface, double scale, const Font& font);

    void clip(const Rect& rect) override;
    void unclip() override;
    void draw(const Path& path, const Pen& pen) override;
    void circle(const Vec<2>& centre, double radius, const Pen& pen) override;
    void gradient(const Rect& rect, std::span<const Colour> stops) override;
    void text(const TextRun& run, const Colour& colour, const Colour& halo) override;

    void end_page();

private:
    void fill_and_stroke(const Pen& pen);

    const Font& font_;
    std::unique_ptr<cairo_t, CairoDestroy> cairo_;
};

}  // namespace sightline
