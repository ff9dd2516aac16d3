// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/legend.h"

#include <algorithm>
#include <array>

#include "core/draw/swatch.h"

namespace sightline {

namespace {

/// Puts swatches and texts down from above.
class Block {
public:
    Block(const Colours& colours, const std::function<ImVec2(const std::string&)>& measure, double point)
        : ink_(colours.ink), measure_(measure), point_(point), line_(measure("X").y) {}

    void row(const LegendRow& row) {
        down(1.22 * line_);
        const double x = pad(), y = y_ + 0.61 * line_;
        const Swatch shape = swatch_of(row, {{x, y - 0.42 * line_}, {x + swatch(), y + 0.42 * line_}}, points(line_));
        box_.list.add(row.swatch, add_style(row.style), shape.points, shape.size_pt);
        // Rows of text alone stand where the swatches begin.
        const bool bare = row.style.fill.a == 0 && row.style.stroke.a == 0 && row.style.hatch_colour.a == 0;
        text(row.text, {bare ? x : x + swatch() + 0.5 * line_, y}, TextAlign::left);
    }

    void bar(const ColourBar& bar) {
        down(1.35 * line_);
        text(bar.title, {pad(), y_ + 0.7 * line_}, TextAlign::left);
        down(0.8 * line_);
        const double w = std::max(9.0 * line_, measured(bar.low) + measured(bar.high) + line_);
        constexpr int steps = 48;
        Style style;
        for (int i = 0; i < steps; ++i) {
            style.fill = between(bar.stops, (i + 0.5) / steps);
            rectangle(add_style(style), {pad() + w * i / steps, y_}, {pad() + w * (i + 1) / steps, y_ + 0.7 * line_});
        }
        Style frame;
        frame.stroke = ink_;
        rectangle(add_style(frame), {pad(), y_}, {pad() + w, y_ + 0.7 * line_});
        wide(w);
        down(1.1 * line_);
        text(bar.low, {pad(), y_ + 0.5 * line_}, TextAlign::left);
        text(bar.high, {pad() + w, y_ + 0.5 * line_}, TextAlign::right);
    }

    /// On the paper; y = 0 goes to the bottom.
    LegendBox take(Colour paper) {
        if (box_.list.shapes.empty() && box_.list.labels.empty()) return {};
        const double h = -y_ + 2 * pad(), w = widest_ + 2 * pad();
        for (Vec<2>& p : box_.list.points) p.y += h - pad();
        for (Label& label : box_.list.labels) label.at.y += h - pad();
        Style plate;
        plate.fill = paper;
        plate.fill.a = 230;
        plate.stroke = ink_;
        plate.stroke.a = 110;
        const auto style = add_style(plate);
        box_.list.add(ShapeKind::polygon, style, {{0.5, 0.5}, {w - 0.5, 0.5}, {w - 0.5, h - 0.5}, {0.5, h - 0.5}});
        std::rotate(box_.list.shapes.begin(), box_.list.shapes.end() - 1, box_.list.shapes.end());
        box_.list.world = {{0, 0}, {w, h}};
        box_.w = static_cast<float>(w);
        box_.h = static_cast<float>(h);
        return std::move(box_);
    }

private:
    double pad() const { return 0.5 * line_; }
    double swatch() const { return 1.8 * line_; }
    double points(double units) const { return units / point_; }
    double measured(const std::string& text) const { return measure_(text).x; }
    void down(double by) { y_ -= by; }
    void wide(double w) { widest_ = std::max(widest_, w); }

    std::uint16_t add_style(const Style& style) {
        box_.list.styles.push_back(style);
        return static_cast<std::uint16_t>(box_.list.styles.size() - 1);
    }
    void rectangle(std::uint16_t style, const Vec<2>& a, const Vec<2>& b) {
        box_.list.add(ShapeKind::polygon, style, {a, {b.x, a.y}, b, {a.x, b.y}});
    }
    void text(const std::string& words, const Vec<2>& at, TextAlign align) {
        Label label;
        label.at = at;
        label.text = words;
        label.align = align;
        label.colour = ink_;
        box_.list.labels.push_back(label);
        if (align == TextAlign::left) wide(at.x - pad() + measured(words));
    }

    Colour ink_;
    const std::function<ImVec2(const std::string&)>& measure_;
    double point_;  ///< of marks, in units
    double line_, y_ = 0, widest_ = 0;
    LegendBox box_;
};

}  // namespace

LegendBox make_legend(std::span<const LegendRow> rows, const std::optional<ColourBar>& bar, const Colours& colours,
                      const std::function<ImVec2(const std::string&)>& measure, float unit, double line_scale) {
    Block block(colours, measure, 4.0 / 3 * unit * line_scale);
    for (const LegendRow& row : rows) block.row(row);
    if (bar && bar->stops.size() > 1) block.bar(*bar);
    return block.take(colours.background);
}

Area legend_place(const LegendBox& legend, const Area& area, float margin, std::span<const ImVec2> points) {
    const float left = area.x + margin, right = area.x + area.w - margin - legend.w, top = area.y + margin,
                bottom = area.y + area.h - margin - legend.h;
    const std::array<Area, 4> corners{Area{left, bottom, legend.w, legend.h}, Area{right, bottom, legend.w, legend.h},
                                      Area{right, top, legend.w, legend.h}, Area{left, top, legend.w, legend.h}};
    for (const Area& corner : corners)
        if (std::none_of(points.begin(), points.end(), [&](const ImVec2& p) { return corner.contains(p); }))
            return corner;
    return corners[0];
}

}  // namespace sightline
