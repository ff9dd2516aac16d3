// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/paint.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/draw/label_place.h"
#include "core/draw/swatch.h"
#include "shell/figure/label.h"
#include "shell/figure/outline.h"

namespace sightline {

namespace {

/// Cut outlines run this far outside the frame, where the canvas's clip hides them.
constexpr double cut_margin = 20;

/// Beyond this a page coordinate is an error of the scene, and arithmetic on it would overflow.
constexpr double absurd = 1e100;

Colour mixed(const Colour& a, const Colour& b, double share) {
    const auto mix = [&](int x, int y) { return static_cast<std::uint8_t>(std::lround(x + (y - x) * share)); };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
}

Pen stroke_of(const Style& style) {
    return {transparent, style.stroke, std::max(style.width_pt, thinnest_pt), style.dash};
}

Pen fill_of(const Colour& colour) { return {colour, transparent}; }

void paint_polygon(Canvas& canvas, std::vector<Vec<2>> points, const Style& style, double pitch) {
    const bool hatched = style.hatch != Hatch::none && style.hatch_colour.a > 0;
    Pen pen = stroke_of(style);
    Path outline;
    outline.closed = true;
    outline.points = std::move(points);
    outline.end_run();
    if (style.fill.a > 0 && (hatched || style.stroke.a == 0)) {
        Pen fill = fill_of(style.fill);
        // Neighbours without an outline would show a hair of background between them.
        if (style.stroke.a == 0 && style.fill.a == 255) fill = {style.fill, style.fill, thinnest_pt};
        canvas.draw(outline, fill);
    } else {
        pen.fill = style.fill;
    }
    if (hatched) {
        const double width = style.hatch == Hatch::dots ? pitch / 3 : thinnest_pt;
        const Path lines = hatch_lines(outline.points, style.hatch, pitch);
        if (!lines.ends.empty()) canvas.draw(lines, {transparent, style.hatch_colour, width});
    }
    if (pen.fill.a > 0 || pen.stroke.a > 0) canvas.draw(outline, pen);
}

void paint_arrow(Canvas& canvas, std::vector<Vec<2>> points, double head, const Style& style, const Rect& cut) {
    const Vec<2> tip = points.back();
    while (points.size() > 1 && points[points.size() - 2] == tip) points.pop_back();
    if (points.size() < 2) return;
    const Vec<2> before = points[points.size() - 2];
    const Vec<2> along = glm::normalize(tip - before), across(-along.y, along.x);
    // The line ends inside the head, or its square end would blunt the tip.
    points.back() = tip - along * std::min(0.8 * head, glm::length(tip - before));
    const Path line = clip_polyline(points, cut);
    if (!line.ends.empty()) canvas.draw(line, stroke_of(style));
    if (!cut.contains(tip)) return;
    Path triangle;
    triangle.closed = true;
    triangle.add({tip, tip - along * head + across * (0.38 * head), tip - along * head - across * (0.38 * head)});
    canvas.draw(triangle, fill_of(style.stroke));
}

/// A shape whose points are on the page already. `pitch` is that of hatches.
void paint_shape(Canvas& canvas, ShapeKind kind, std::vector<Vec<2>> points, double size, const Style& style,
                 const Rect& frame, double pitch) {
    if (points.empty()) return;
    Box<2> box;
    for (const Vec<2>& p : points) {
        if (!(std::abs(p.x) < absurd && std::abs(p.y) < absurd)) return;
        box.add(p);
    }
    const double reach = std::max(style.width_pt, thinnest_pt) / 2 + std::max(size, 0.0);
    const Rect around = Rect{box.min.x, box.min.y, box.extent().x, box.extent().y}.grown(reach);
    if (!frame.overlaps(around)) return;
    const Rect cut = frame.grown(std::max(cut_margin, reach));
    const bool inside = cut.contains(around);
    const Vec<2> at = points.front();
    switch (kind) {
        case ShapeKind::polygon:
            if (points.size() < 3) return;
            if (!inside) points = clip_polygon(points, cut);
            if (points.size() >= 3) paint_polygon(canvas, std::move(points), style, pitch);
            return;
        case ShapeKind::polyline: {
            if (points.size() < 2 || style.stroke.a == 0) return;
            const Path line = clip_polyline(points, cut);
            if (!line.ends.empty()) canvas.draw(line, stroke_of(style));
            return;
        }
        case ShapeKind::disc:
        case ShapeKind::ring: {
            Pen pen = stroke_of(style);
            if (kind == ShapeKind::disc) pen.fill = style.fill;
            if (size > 0 && (pen.fill.a > 0 || pen.stroke.a > 0)) canvas.circle(at, size, pen);
            return;
        }
        case ShapeKind::cross: {
            Path path;
            path.add({at + Vec<2>(-size, -size), at + Vec<2>(size, size)});
            path.add({at + Vec<2>(-size, size), at + Vec<2>(size, -size)});
            if (size > 0 && style.stroke.a > 0) canvas.draw(path, stroke_of(style));
            return;
        }
        case ShapeKind::arrow:
            if (style.stroke.a > 0)
                paint_arrow(canvas, std::move(points), size > 0 ? size : std::max(4.0, 4 * style.width_pt), style, cut);
            return;
    }
}

/// From the border of the label's box to what it speaks of.
void paint_leader(Canvas& canvas, const PlacedLabel& placed, const Colour& colour, const Rect& frame, double lines) {
    const Rect box = placed.box.grown(1);
    if (!placed.tip || box.contains(*placed.tip)) return;
    Style style;
    style.stroke = colour;
    style.width_pt = 0.8 * lines;
    const Vec<2> from = leader_start({{box.x, box.y}, {box.right(), box.bottom()}}, *placed.tip);
    paint_arrow(canvas, {from, *placed.tip}, 4 * lines, style, frame);
}

/// `lines`: as line_scale.
void paint_solid(Canvas& canvas, const SolidList& solid, const Rect& rect, double lines, const DrawSolid& draw_solid) {
    if (!draw_solid) throw WorkError("the figure has a picture in 3D, and there is no OpenGL to draw it with");
    canvas.image(rect, [&](int width, int height, double px_per_pt) {
        Pixels pixels = draw_solid(solid, width, height, px_per_pt * lines);
        if (pixels.width != width || pixels.height != height)
            throw WorkError("a picture in 3D has the wrong number of pixels");
        return pixels;
    });
}

Path rectangle(const Rect& r) {
    Path path;
    path.closed = true;
    path.add({{r.x, r.y}, {r.right(), r.y}, {r.right(), r.bottom()}, {r.x, r.bottom()}});
    return path;
}

/// The shapes of a list, with a place on the page for each of its points, cut to a frame.
template <typename ToPage>
void paint_shapes(Canvas& canvas, const DrawList& list, double lines, const Rect& frame, double pitch,
                  ToPage&& on_page) {
    std::vector<Style> styles = list.styles;
    for (Style& style : styles) style.width_pt *= lines;
    for (const Shape& s : list.shapes) {
        if (s.style >= styles.size() || std::size_t{s.first_point} + s.point_count > list.points.size()) continue;
        std::vector<Vec<2>> points;
        points.reserve(s.point_count);
        for (std::uint32_t i = 0; i < s.point_count; ++i) points.push_back(on_page(list.points[s.first_point + i]));
        paint_shape(canvas, s.kind, std::move(points), s.size_pt * lines, styles[s.style], frame, pitch);
    }
}

void paint_inset(Canvas& canvas, const Figure::Inset& inset, const PlacedInset& placed, const Figure& figure,
                 double lines, double pitch, const Rect& frame, const DrawSolid& draw_solid) {
    if (inset.list) {
        canvas.unclip();  // clips are not nested
        const Box<2>& world = inset.list->world;
        const Vec<2> scale(placed.box.w / world.extent().x, placed.box.h / world.extent().y);
        Pen paper = fill_of(figure.background);
        paper.fill.a = 255;
        canvas.clip(placed.box);
        canvas.draw(rectangle(placed.box), paper);
        paint_shapes(canvas, *inset.list, lines, placed.box, pitch, [&](const Vec<2>& p) {
            return Vec<2>(placed.box.x + (p.x - world.min.x) * scale.x,
                          placed.box.bottom() - (p.y - world.min.y) * scale.y);
        });
        canvas.unclip();
        canvas.clip(frame);
    }
    if (inset.solid) paint_solid(canvas, *inset.solid, placed.box, lines, draw_solid);
    if (inset.pixels)
        canvas.image(placed.box, [&](int width, int height, double) { return resized(*inset.pixels, width, height); });
    Pen paper = fill_of(figure.background);
    paper.fill.a = 255;
    canvas.draw(rectangle(placed.paper), paper);
    canvas.draw(rectangle(placed.box), {transparent, figure.ink, 0.75});
    canvas.text(placed.title, figure.ink);
}

void paint_panel(Canvas& canvas, const Figure& figure, std::size_t i, const Layout& layout, const Font& font,
                 double pitch, const DrawSolid& draw_solid) {
    const Figure::Panel& content = figure.panels[i];
    const Layout::Panel& panel = layout.panels[i];
    const DrawList& list = content.list;
    const double lines = line_scale(layout);
    canvas.clip(panel.frame);
    if (content.solid) paint_solid(canvas, *content.solid, world_on_page(list, panel, layout.scale), lines, draw_solid);
    paint_shapes(canvas, list, lines, panel.frame, pitch,
                 [&](const Vec<2>& p) { return to_page(panel, layout.scale, p); });
    const PlacedTexts texts = place_texts(content, panel, layout, font);
    for (const PlacedLabel& placed : texts.labels)
        paint_leader(canvas, placed, list.labels[placed.label].disc.value_or(list.labels[placed.label].colour),
                     panel.frame, lines);
    for (const PlacedLabel& placed : texts.labels) {
        const Label& label = list.labels[placed.label];
        if (label.disc) canvas.circle(placed.centre, placed.radius, fill_of(*label.disc));
        for (const TextRun& run : placed.runs)
            if (!run.text.empty()) canvas.text(run, label.colour, label.halo);
    }
    for (std::size_t k = 0; k < texts.insets.size(); ++k)
        paint_inset(canvas, content.insets[k], texts.insets[k], figure, lines, pitch, panel.frame, draw_solid);
    canvas.unclip();
}

void paint_swatch(Canvas& canvas, const LegendRow& row, const Rect& swatch, double size, double pitch, double lines) {
    LegendRow scaled = row;
    scaled.style.width_pt *= lines;
    const Swatch shape = swatch_of(scaled, {{swatch.x, swatch.y}, {swatch.right(), swatch.bottom()}}, size);
    paint_shape(canvas, row.swatch, shape.points, shape.size_pt, scaled.style, swatch.grown(2), pitch);
}

}  // namespace

void paint(Canvas& canvas, const Figure& figure, const Layout& layout, const Font& font, const DrawSolid& draw_solid) {
    const Rect page{0, 0, layout.width, layout.height};
    const Colour frame = mixed(figure.ink, figure.background, 0.45);
    const double pitch = std::max(2.5, 0.4 * layout.font_pt);
    const Pen border{transparent, frame, thinnest_pt};
    // A last row of pixels may lie only partly on the page.
    if (figure.background.a > 0) canvas.draw(rectangle(page.grown(1)), fill_of(figure.background));
    const auto write = [&](const std::vector<TextRun>& runs) {
        for (const TextRun& run : runs) canvas.text(run, figure.ink);
    };
    for (std::size_t i = 0; i < layout.panels.size(); ++i) {
        const Layout::Panel& panel = layout.panels[i];
        paint_panel(canvas, figure, i, layout, font, pitch, draw_solid);
        canvas.draw(rectangle(panel.frame), border);
        write(panel.title);
    }
    if (layout.legend_box) {
        Pen pen = border;
        pen.fill = figure.background;
        pen.fill.a = 255;
        canvas.draw(rectangle(*layout.legend_box), pen);
    }
    for (std::size_t i = 0; i < layout.legend.size(); ++i) {
        paint_swatch(canvas, figure.legend[i], layout.legend[i].swatch, layout.font_pt, pitch, line_scale(layout));
        write(layout.legend[i].text);
    }
    if (layout.bar) {
        if (!figure.bar->stops.empty()) canvas.gradient(layout.bar->strip, figure.bar->stops);
        canvas.draw(rectangle(layout.bar->strip), border);
        write(layout.bar->text);
    }
    write(layout.caption);
}

}  // namespace sightline
