// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/svg_canvas.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/quote.h"
#include "shell/figure/cairo_surface.h"
#include "shell/figure/png.h"

namespace sightline {

namespace {

/// Coordinates are whole hundredths of a point, so that relative steps add up without drift.
long hundredths(double value) { return std::lround(value * 100); }

void append_hundredths(std::string& out, long value) {
    if (value < 0) out += '-';
    value = std::abs(value);
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, value / 100).ptr;
    if (value >= 100 || value == 0) out.append(digits, end);
    if (const long rest = value % 100; rest != 0) {
        out += '.';
        out += static_cast<char>('0' + rest / 10);
        if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
    }
}

std::string num(double value) {
    std::string out;
    append_hundredths(out, hundredths(value));
    return out;
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string hex(const Colour& c) {
    std::string text = "#";
    for (const std::uint8_t part : {c.r, c.g, c.b}) {
        text += "0123456789abcdef"[part >> 4];
        text += "0123456789abcdef"[part & 15];
    }
    return text;
}

std::string opacity(std::uint8_t a) {
    char text[16];
    return {text, std::to_chars(text, text + sizeof text, std::round(a / 255.0 * 1000) / 1000).ptr};
}

std::string paint_css(const std::string& name, const Colour& c) {
    if (c.a == 0) return name + ":none;";
    return name + ":" + hex(c) + ";" + (c.a < 255 ? name + "-opacity:" + opacity(c.a) + ";" : "");
}

std::string pen_css(const Pen& pen) {
    std::string text = paint_css("fill", pen.fill) + paint_css("stroke", pen.stroke);
    if (pen.stroke.a == 0) return text;
    text += "stroke-width:" + num(pen.width) + ";stroke-linejoin:round;";
    if (pen.dash != Dash::dashed) text += "stroke-linecap:round;";
    if (const std::vector<double> dashes = dash_lengths(pen); !dashes.empty())
        text += "stroke-dasharray:" + num(dashes[0]) + " " + num(dashes[1]) + ";";
    return text;
}

/// Runs as path data: absolute starts, relative steps.
void append_runs(std::string& out, const Path& path) {
    std::size_t i = 0;
    for (const std::uint32_t end : path.ends) {
        long x = 0, y = 0;
        for (const std::size_t begin = i; i < end; ++i) {
            const long to_x = hundredths(path.points[i].x), to_y = hundredths(path.points[i].y);
            if (i == begin)
                out += 'M';
            else if (i == begin + 1)
                out += 'l';
            else if (to_x - x >= 0)
                out += ' ';
            append_hundredths(out, to_x - x);
            if (to_y - y >= 0) out += ' ';
            append_hundredths(out, to_y - y);
            x = to_x;
            y = to_y;
        }
        if (path.closed) out += 'z';
    }
}

/// Names made from content: figures pasted into one page cannot disturb each other.
std::string content_name(const char* prefix, std::string_view content) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    char text[20];
    return prefix + std::string(text, std::to_chars(text, text + sizeof text, hash, 16).ptr);
}

}  // namespace

void SvgCanvas::end_path() {
    if (!path_class_.empty()) body_ += "\"/>\n";
    path_class_.clear();
}

std::string SvgCanvas::class_of(const std::string& declarations) {
    return classes_.try_emplace(declarations, "s" + std::to_string(classes_.size())).first->second;
}

void SvgCanvas::clip(const Rect& r) {
    end_path();
    const std::string rect = "<rect" + attribute("x", num(r.x)) + attribute("y", num(r.y)) +
                             attribute("width", num(r.w)) + attribute("height", num(r.h)) + "/>";
    const std::string id = content_name("clip-", rect);
    if (defined_.insert(id).second) defs_ += "<clipPath id=\"" + id + "\">" + rect + "</clipPath>\n";
    body_ += "<g clip-path=\"url(#" + id + ")\">\n";
}

void SvgCanvas::unclip() {
    end_path();
    body_ += "</g>\n";
}

void SvgCanvas::draw(const Path& path, const Pen& pen) {
    const std::string name = class_of(pen_css(pen));
    // Opaque lines look the same in one path as in many. Parsers limit the length of an attribute.
    const bool joins = pen.fill.a == 0 && pen.stroke.a == 255 && pen.dash == Dash::solid;
    if (path_class_ != name || !joins || body_.size() - path_begin_ > 50000) end_path();
    if (path_class_.empty()) {
        path_begin_ = body_.size();
        body_ += "<path" + attribute("class", name) + " d=\"";
        path_class_ = name;
    }
    append_runs(body_, path);
    if (!joins) end_path();
}

void SvgCanvas::circle(const Vec<2>& centre, double radius, const Pen& pen) {
    end_path();
    body_ += "<circle" + attribute("class", class_of(pen_css(pen))) + attribute("cx", num(centre.x)) +
             attribute("cy", num(centre.y)) + attribute("r", num(radius)) + "/>\n";
}

void SvgCanvas::gradient(const Rect& rect, std::span<const Colour> stops) {
    end_path();
    std::string content;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const double at = stops.size() > 1 ? static_cast<double>(i) / static_cast<double>(stops.size() - 1) : 0;
        content += "<stop" + attribute("offset", num(at * 100) + "%") + attribute("stop-color", hex(stops[i]));
        if (stops[i].a < 255) content += attribute("stop-opacity", opacity(stops[i].a));
        content += "/>";
    }
    const std::string id = content_name("bar-", content);
    if (defined_.insert(id).second) defs_ += "<linearGradient id=\"" + id + "\">" + content + "</linearGradient>\n";
    body_ += "<rect" + attribute("x", num(rect.x)) + attribute("y", num(rect.y)) + attribute("width", num(rect.w)) +
             attribute("height", num(rect.h)) + " fill=\"url(#" + id + ")\"/>\n";
}

void SvgCanvas::image(const Rect& rect, const DrawImage& draw) {
    end_path();
    has_image_ = true;
    const PixelRect place = pixel_rect(rect, dpi_ / 72);
    const CairoSurface surface = image_of(draw(place.w, place.h, place.px_per_pt));
    body_ += "<image" + attribute("x", num(place.rect.x)) + attribute("y", num(place.rect.y)) +
             attribute("width", num(place.rect.w)) + attribute("height", num(place.rect.h)) +
             " preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,";
    body_ += base64(encode_png(surface.get(), dpi_));
    body_ += "\"/>\n";
}

void SvgCanvas::text(const TextRun& run, const Colour& colour, const Colour& halo) {
    std::string css = "font-size:" + num(run.size) + "px;" + paint_css("fill", colour);
    if (run.align != TextAlign::left)
        css += run.align == TextAlign::centre ? "text-anchor:middle;" : "text-anchor:end;";
    if (halo.a > 0) css += paint_css("stroke", halo) + "stroke-width:2;stroke-linejoin:round;paint-order:stroke;";
    end_path();
    body_ += "<text" + attribute("class", class_of(css)) + attribute("x", num(run.x)) +
             attribute("y", num(run.baseline)) + ">" + escaped(run.text) + "</text>\n";
    for (const char32_t c : code_points(run.text)) used_.insert(c);
}

std::string SvgCanvas::document(const std::string& width, const std::string& height, double width_pt,
                                double height_pt) {
    end_path();
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
    // Readers of SVG 1.1 know no other link.
    if (has_image_) out += " xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
    out += attribute("width", width) + attribute("height", height);
    out += attribute("viewBox", "0 0 " + num(width_pt) + " " + num(height_pt));
    std::string style, rules;
    if (!used_.empty()) {
        const std::string file = subset_font(font_, used_);
        const std::string name = content_name("sightline-", file);
        // Programs that ignore embedded fonts find the whole one where it is installed.
        out += attribute("font-family", "'" + name + "', '" + font_.family + "', sans-serif");
        style = "@font-face{font-family:'" + name + "';src:url(data:font/ttf;base64," + base64(file) +
                ") format('truetype')}\n";
        rules = " text{font-kerning:normal;font-variant-ligatures:none;white-space:pre}\n";
    }
    // In the order of their numbers, within a name made from what they say.
    std::vector<std::pair<std::string, std::string>> by_name;
    for (const auto& [css, name] : classes_) by_name.emplace_back(name, css);
    std::sort(by_name.begin(), by_name.end(), [](const auto& a, const auto& b) {
        return std::pair(a.first.size(), a.first) < std::pair(b.first.size(), b.first);
    });
    for (const auto& [name, css] : by_name) rules += " ." + name + "{" + css + "}\n";
    const std::string root = content_name("figure-", rules);
    for (std::size_t at = 0; at < rules.size(); at = rules.find('\n', at) + 1) {
        rules.insert(at, "." + root);
    }
    out += attribute("class", root) + ">\n<style>\n" + style + rules + "</style>\n";
    if (!defs_.empty()) out += "<defs>\n" + defs_ + "</defs>\n";
    return out + body_ + "</svg>\n";
}

}  // namespace sightline
