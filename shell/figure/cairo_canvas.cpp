// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/cairo_canvas.h"

#include <cairo-ft.h>
#include <cairo.h>

#include "core/base/error.h"
#include "shell/figure/handle.h"

namespace sightline {

namespace {

void set_source(cairo_t* cairo, const Colour& c) {
    cairo_set_source_rgba(cairo, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0);
}

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw WorkError(std::string("cannot draw the figure: ") + cairo_status_to_string(status));
}

/// By file and index, so that the system's settings for screens (hinting, subpixels) stay out of it.
void set_font(cairo_t* cairo, const Font& font) {
    const Handle<FcPattern, FcPatternDestroy> pattern(FcPatternCreate());
    FcPatternAddString(pattern.get(), FC_FILE, reinterpret_cast<const FcChar8*>(font.file.c_str()));
    FcPatternAddInteger(pattern.get(), FC_INDEX, font.index);
    const Handle<cairo_font_face_t, cairo_font_face_destroy> face(cairo_ft_font_face_create_for_pattern(pattern.get()));
    cairo_set_font_face(cairo, face.get());  // an error shows in the context's own status
    const Handle<cairo_font_options_t, cairo_font_options_destroy> options(cairo_font_options_create());
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(cairo, options.get());
}

}  // namespace

CairoCanvas::CairoCanvas(cairo_surface_t* surface, double scale, double px_per_pt, const Font& font)
    : font_(font), px_per_pt_(px_per_pt), cairo_(cairo_create(surface)) {
    cairo_scale(cairo_.get(), scale, scale);
    set_font(cairo_.get(), font);
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    check(cairo_status(cairo_.get()));
}

void CairoCanvas::clip(const Rect& r) {
    cairo_save(cairo_.get());
    cairo_rectangle(cairo_.get(), r.x, r.y, r.w, r.h);
    cairo_clip(cairo_.get());
}

void CairoCanvas::unclip() { cairo_restore(cairo_.get()); }

void CairoCanvas::fill_and_stroke(const Pen& pen) {
    cairo_t* c = cairo_.get();
    if (pen.fill.a > 0) {
        set_source(c, pen.fill);
        cairo_fill_preserve(c);
    }
    if (pen.stroke.a > 0) {
        set_source(c, pen.stroke);
        cairo_set_line_width(c, pen.width);
        cairo_set_line_cap(c, pen.dash == Dash::dashed ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
        const std::vector<double> dashes = dash_lengths(pen);
        cairo_set_dash(c, dashes.data(), static_cast<int>(dashes.size()), 0);
        cairo_stroke_preserve(c);
    }
    cairo_new_path(c);
}

void CairoCanvas::draw(const Path& path, const Pen& pen) {
    cairo_t* c = cairo_.get();
    std::size_t i = 0;
    for (const std::uint32_t end : path.ends) {
        cairo_new_sub_path(c);
        for (; i < end; ++i) cairo_line_to(c, path.points[i].x, path.points[i].y);
        if (path.closed) cairo_close_path(c);
    }
    fill_and_stroke(pen);
}

void CairoCanvas::circle(const Vec<2>& centre, double radius, const Pen& pen) {
    cairo_new_sub_path(cairo_.get());
    cairo_arc(cairo_.get(), centre.x, centre.y, radius, 0, 6.283185307179586);
    cairo_close_path(cairo_.get());
    fill_and_stroke(pen);
}

void CairoCanvas::gradient(const Rect& rect, std::span<const Colour> stops) {
    const Handle<cairo_pattern_t, cairo_pattern_destroy> pattern(
        cairo_pattern_create_linear(rect.x, 0, rect.right(), 0));
    for (std::size_t i = 0; i < stops.size(); ++i)
        cairo_pattern_add_color_stop_rgba(
            pattern.get(), stops.size() > 1 ? static_cast<double>(i) / static_cast<double>(stops.size() - 1) : 0,
            stops[i].r / 255.0, stops[i].g / 255.0, stops[i].b / 255.0, stops[i].a / 255.0);
    cairo_set_source(cairo_.get(), pattern.get());
    cairo_rectangle(cairo_.get(), rect.x, rect.y, rect.w, rect.h);
    cairo_fill(cairo_.get());
}

void CairoCanvas::image(const Rect& rect, const DrawImage& draw) {
    cairo_t* c = cairo_.get();
    const PixelRect place = pixel_rect(rect, px_per_pt_);
    const CairoSurface surface = image_of(draw(place.w, place.h, place.px_per_pt));
    cairo_save(c);
    cairo_translate(c, place.rect.x, place.rect.y);
    cairo_scale(c, place.rect.w / place.w, place.rect.h / place.h);
    cairo_set_source_surface(c, surface.get(), 0, 0);
    cairo_paint(c);
    cairo_restore(c);
}

void CairoCanvas::text(const TextRun& run, const Colour& colour, const Colour& halo) {
    cairo_t* c = cairo_.get();
    const ShapedText shaped = shape(font_, run.text);
    std::vector<cairo_glyph_t> glyphs;
    // Clusters tie glyphs to their characters, so that a reader of the PDF can copy the text.
    std::vector<cairo_text_cluster_t> clusters;
    for (std::size_t i = 0; i < shaped.glyphs.size(); ++i) {
        const Glyph& g = shaped.glyphs[i];
        glyphs.push_back({g.id, run.left() + g.x * run.size, run.baseline - g.y * run.size});
        if (i == 0 || g.text_at != shaped.glyphs[i - 1].text_at) {
            if (i > 0) clusters.back().num_bytes = static_cast<int>(g.text_at) - clusters.back().num_bytes;
            clusters.push_back({static_cast<int>(g.text_at), 0});
        }
        ++clusters.back().num_glyphs;
    }
    if (glyphs.empty()) return;
    clusters.back().num_bytes = static_cast<int>(run.text.size()) - clusters.back().num_bytes;
    const int count = static_cast<int>(glyphs.size());
    cairo_set_font_size(c, run.size);
    if (halo.a > 0) {
        cairo_glyph_path(c, glyphs.data(), count);
        fill_and_stroke({transparent, halo, 2});
    }
    set_source(c, colour);
    cairo_show_text_glyphs(c, run.text.data(), static_cast<int>(run.text.size()), glyphs.data(), count, clusters.data(),
                           static_cast<int>(clusters.size()), static_cast<cairo_text_cluster_flags_t>(0));
}

void CairoCanvas::end_page() {
    cairo_show_page(cairo_.get());
    check(cairo_status(cairo_.get()));
}

}  // namespace sightline
