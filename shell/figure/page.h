// What layout, painting and the writers share: rectangles, text runs and paths in points, y down from the top left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/draw/draw_list.h"

namespace sightline {

/// A rectangle on the page.
struct Rect {
    double x = 0, y = 0, w = 0, h = 0;

    double right() const { return x + w; }
    double bottom() const { return y + h; }
    Rect grown(double by) const { return {x - by, y - by, w + 2 * by, h + 2 * by}; }
    bool contains(const Vec<2>& p) const { return p.x >= x && p.x <= right() && p.y >= y && p.y <= bottom(); }
    bool contains(const Rect& r, double slack = 0) const {
        return r.x >= x - slack && r.y >= y - slack && r.right() <= right() + slack && r.bottom() <= bottom() + slack;
    }
    /// True when the two share more than a border of `slack`.
    bool overlaps(const Rect& r, double slack = 0) const {
        return x + slack < r.right() && r.x + slack < right() && y + slack < r.bottom() && r.y + slack < bottom();
    }
};

/// A rectangle of the page as whole pixels.
struct PixelRect {
    int w = 1, h = 1;
    double px_per_pt = 1;
    Rect rect;  ///< what they cover: the rectangle with its sides moved to whole multiples of a pixel
};

/// With so many pixels to the point, or fewer where a side would have more than largest_solid_picture.
PixelRect pixel_rect(const Rect& rect, double px_per_pt);

/// One line of text on the page. x is its left end, centre or right end, as `align` says.
struct TextRun {
    std::string text;  ///< valid UTF-8 without control characters
    double x = 0, baseline = 0, size = 8;
    double width = 0;  ///< measured
    TextAlign align = TextAlign::left;

    double left() const {
        return align == TextAlign::left ? x : align == TextAlign::centre ? x - width / 2 : x - width;
    }
};

/// Several runs of points, drawn as one.
struct Path {
    std::vector<Vec<2>> points;
    std::vector<std::uint32_t> ends;  ///< one past the last point of each run
    bool closed = false;

    void add(std::initializer_list<Vec<2>> run) {
        for (const Vec<2>& p : run) points.push_back(p);  // of insert() GCC 12 has a false alarm
        end_run();
    }
    /// Ends the run that was being appended to `points`.
    void end_run() { ends.push_back(static_cast<std::uint32_t>(points.size())); }
};

/// How a path is put down. A colour with a = 0 is not drawn.
struct Pen {
    Colour fill = transparent, stroke = transparent;
    double width = 0.5;
    Dash dash = Dash::solid;
    bool operator==(const Pen&) const = default;
};

/// The lengths of a dash and the gap after it; empty for a solid line. Dots are dashes of no length with round ends.
inline std::vector<double> dash_lengths(const Pen& pen) {
    const double w = pen.width < 0.75 ? 0.75 : pen.width;
    if (pen.dash == Dash::dashed) return {3.5 * w, 2.5 * w};
    if (pen.dash == Dash::dotted) return {0, 2.5 * w};
    return {};
}

/// No line of a figure is thinner than this at its final size.
inline constexpr double thinnest_pt = 0.5;

}  // namespace sightline
