// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/cover.h"

#include "shell/figure/label.h"
#include "shell/figure/outline.h"

namespace sightline {

double covered(const DrawList& list, const Layout::Panel& panel, const Layout& layout, const Font& font,
               const Rect& box) {
    const double line_weight = 3, mark_weight = 10, label_weight = 150;
    double sum = 0;
    std::vector<Vec<2>> points;
    for (const Shape& s : list.shapes) {
        if (std::size_t{s.first_point} + s.point_count > list.points.size() || s.point_count == 0) continue;
        points.clear();
        bool usable = true;
        for (std::uint32_t i = 0; i < s.point_count; ++i) {
            points.push_back(to_page(panel, layout.scale, list.points[s.first_point + i]));
            usable &= std::abs(points.back().x) < 1e100 && std::abs(points.back().y) < 1e100;
        }
        if (!usable) continue;
        const bool area = s.kind == ShapeKind::polygon;
        const bool line = s.kind == ShapeKind::polyline || s.kind == ShapeKind::arrow;
        if (!area && !line && box.grown(s.size_pt).contains(points[0])) sum += mark_weight;
        if (!area && !line) continue;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            sum += clipped_length(points[i], points[i + 1], box) * (line ? line_weight : 1);
        if (area) sum += clipped_length(points.back(), points[0], box);
    }
    for (const Label& label : list.labels) {
        const auto placed = place_label(label, panel, layout, font);
        if (placed && placed->box.overlaps(box)) sum += label_weight;
    }
    return sum;
}

Rect emptiest_corner(std::span<const Figure> pages, std::span<const Layout> layouts, const Font& font, double w,
                     double h, double inset) {
    Rect best{0, 0, w, h};
    double least = -1;
    std::size_t panels = 0;
    for (const Layout& layout : layouts) panels = std::max(panels, layout.panels.size());
    for (std::size_t i = 0; i < panels; ++i) {
        const auto has = [&](const Layout& layout) { return i < layout.panels.size(); };
        const Rect f = std::find_if(layouts.begin(), layouts.end(), has)->panels[i].frame;
        if (f.w < w + 2 * inset || f.h < h + 2 * inset) continue;
        const double left = f.x + inset, right = f.right() - inset - w;
        const double top = f.y + inset, bottom = f.bottom() - inset - h;
        for (const Rect box :
             {Rect{right, top, w, h}, Rect{left, top, w, h}, Rect{right, bottom, w, h}, Rect{left, bottom, w, h}}) {
            double sum = 0;
            for (std::size_t p = 0; p < pages.size(); ++p)
                if (has(layouts[p]))
                    sum += covered(pages[p].panels[i].list, layouts[p].panels[i], layouts[p], font, box.grown(2));
            if (least < 0 || sum < least) {
                least = sum;
                best = box;
            }
        }
    }
    return best;
}

}  // namespace sightline
