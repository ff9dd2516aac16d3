// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/figure.h"

#include <cairo-pdf.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/output_file.h"
#include "shell/figure/cairo_canvas.h"
#include "shell/figure/label.h"
#include "shell/figure/lay_out.h"
#include "shell/figure/paint.h"
#include "shell/figure/png.h"
#include "shell/figure/svg_canvas.h"

namespace sightline {

namespace {

enum class Format : std::uint8_t { png, svg, pdf };

Format format_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
    if (ending == ".png") return Format::png;
    if (ending == ".svg") return Format::svg;
    if (ending == ".pdf") return Format::pdf;
    throw InputError("cannot write " + path.string() + ": " +
                     (ending.empty() ? std::string("the name has no extension") : "unknown extension " + ending) +
                     "; use .png, .svg or .pdf");
}

bool in_pixels(const FigureSize& size) { return size.width_px > 0; }

/// Three decimals and no trailing zeros.
std::string decimal_text(double value) {
    std::string text = std::to_string(std::round(value * 1000) / 1000);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string svg_of(const Figure& figure, const FigureSize& size, const Layout& layout, const Font& font,
                   const DrawSolid& draw_solid) {
    SvgCanvas canvas(size.dpi, font);
    paint(canvas, figure, layout, font, draw_solid);
    const auto length = [](double pt) { return decimal_text(pt * 25.4 / 72) + "mm"; };
    if (in_pixels(size))
        return canvas.document(std::to_string(size.width_px), std::to_string(size.height_px), layout.width,
                               layout.height);
    return canvas.document(length(layout.width), length(layout.height), layout.width, layout.height);
}

std::string png_of(const Figure& figure, const FigureSize& size, const Layout& layout, const Font& font,
                   const DrawSolid& draw_solid) {
    const double dpi = in_pixels(size) ? 96 : size.dpi, scale = dpi / 72;
    const double width = in_pixels(size) ? size.width_px : std::max(1.0, std::round(layout.width * scale));
    const double height = in_pixels(size) ? size.height_px : std::ceil(layout.height * scale - 1e-6);
    if (std::max(width, height) > 20000)
        throw InputError("a PNG of " + decimal_text(width) + "x" + decimal_text(height) + " px at " +
                         decimal_text(dpi) + " dpi is too large: at most 20000 px a side; lower the dpi or the size");
    const cairo_format_t format = figure.background.a == 255 ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32;
    const CairoSurface surface(cairo_image_surface_create(format, static_cast<int>(width), static_cast<int>(height)));
    CairoCanvas canvas(surface.get(), scale, scale, font);
    paint(canvas, figure, layout, font, draw_solid);
    canvas.end_page();
    return encode_png(surface.get(), dpi);
}

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

std::string pdf_of(const MakePage& page, std::span<const Layout> layouts, double dpi, const Font& font,
                   const DrawSolid& draw_solid) {
    // Acrobat reads no page beyond 200 inches.
    if (std::max(layouts.front().width, layouts.front().height) > 14400)
        throw InputError("a PDF page of " + decimal_text(layouts.front().width) + "x" +
                         decimal_text(layouts.front().height) + " pt is too large: at most 14400 pt a side");
    std::string data;
    {
        const CairoSurface surface(
            cairo_pdf_surface_create_for_stream(append, &data, layouts.front().width, layouts.front().height));
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "Sightline");
        // The same figure is the same file, whenever it is written.
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
        CairoCanvas canvas(surface.get(), 1, dpi / 72, font);
        for (std::size_t i = 0; i < layouts.size(); ++i) {
            paint(canvas, page(i), layouts[i], font, draw_solid);
            canvas.end_page();
        }
        cairo_surface_finish(surface.get());
        if (const cairo_status_t status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
            throw WorkError(std::string("cannot write the PDF: ") + cairo_status_to_string(status));
    }
    return data;
}

void save(const std::filesystem::path& path, std::string_view data) {
    OutputFile file(path);
    file.write(data);
    file.commit();
}

}  // namespace

void check_figure_name(const std::filesystem::path& path) { format_of(path); }

std::string figure_bytes(const Figure& figure, const FigureSize& size, const std::filesystem::path& path,
                         const DrawSolid& draw_solid) {
    const Format format = format_of(path);
    check_size(size);
    const Font font = find_font();
    const std::vector<Layout> layouts = lay_out({&figure, 1}, size, font);
    if (format == Format::png) return png_of(figure, size, layouts[0], font, draw_solid);
    if (format == Format::svg) return svg_of(figure, size, layouts[0], font, draw_solid);
    return pdf_of([&](std::size_t) { return figure; }, layouts, size.dpi, font, draw_solid);
}

void write_figure(const Figure& figure, const FigureSize& size, const std::filesystem::path& path,
                  const DrawSolid& draw_solid) {
    save(path, figure_bytes(figure, size, path, draw_solid));
}

std::vector<std::string> left_out(const Figure& figure, const FigureSize& size) {
    const Font font = find_font();
    return left_out(figure, lay_out({&figure, 1}, size, font).front(), font, size.font_pt);
}

void write_figure_pages(std::span<const Figure> plan, const MakePage& page, const FigureSize& size,
                        const std::filesystem::path& path, const DrawSolid& draw_solid) {
    if (format_of(path) != Format::pdf)
        throw InputError("cannot write " + path.string() + ": several pages need the extension .pdf");
    if (plan.empty()) throw InputError("cannot write " + path.string() + ": there are no pages");
    check_size(size);
    const Font font = find_font();
    save(path, pdf_of(page, lay_out(plan, size, font), size.dpi, font, draw_solid));
}

void write_figure_frames(std::span<const Figure> plan, const MakePage& page, const FigureSize& size,
                         const std::function<std::filesystem::path(std::size_t)>& file, const DrawSolid& draw_solid) {
    check_size(size);
    const Font font = find_font();
    const std::vector<Layout> layouts = lay_out(plan, size, font);
    for (std::size_t i = 0; i < plan.size(); ++i) save(file(i), png_of(page(i), size, layouts[i], font, draw_solid));
}

}  // namespace sightline
