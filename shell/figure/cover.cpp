// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/cover.h"

#include "core/draw/solid_list.h"
#include "core/raster/image_plane.h"
#include "shell/figure/inset.h"
#include "shell/figure/label.h"
#include "shell/figure/outline.h"

namespace sightline {

namespace {

/// Enough of a solid to tell where it is.
constexpr std::size_t enough = 20000;

double covered_by_solid(const SolidList& solid, const Rect& place, const Rect& box) {
    const ImagePlane plane = image_plane(solid.camera);
    const auto length = [&](const Vec<3>& a, const Vec<3>& b) {
        Vec<3> p = plane.project(a), q = plane.project(b);
        if (p.z > q.z) std::swap(p, q);
        const double near = 1e-4 * q.z;
        if (!(q.z > 0)) return 0.0;
        if (p.z < near) p = q + (p - q) * ((q.z - near) / (q.z - p.z));  // what lies behind the eye is not seen
        const auto on_page = [&](const Vec<3>& v) {
            return Vec<2>(place.x + (v.x / v.z + 1) / 2 * place.w, place.bottom() - (v.y / v.z + 1) / 2 * place.h);
        };
        const Vec<2> from = on_page(p), to = on_page(q);
        return is_finite<2>(from) && is_finite<2>(to) ? clipped_length(from, to, box) : 0.0;
    };
    const auto outline = [&](std::span<const Vec<3>> points) {
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i) sum += length(points[i], points[(i + 1) % points.size()]);
        return sum;
    };
    const auto step = [](std::size_t count) { return count / enough + 1; };
    // What names points or triangles that there are not is not drawn either.
    double faces = 0, triangles = 0;
    const std::size_t face_step = step(solid.face_begin.size()), triangle_step = step(solid.triangles.size());
    for (std::size_t i = 0; i + 1 < solid.face_begin.size(); i += face_step) {
        const std::size_t begin = solid.face_begin[i], end = solid.face_begin[i + 1];
        if (begin < end && end <= solid.points.size()) faces += outline({solid.points.data() + begin, end - begin});
    }
    for (const SolidList::Run& run : solid.runs)
        for (std::size_t i = run.first; i < std::min(std::size_t{run.first} + run.count, solid.triangles.size());
             i += triangle_step)
            if (solid.scene && solid.triangles[i] < solid.scene->primitives.size())
                triangles += outline(solid.scene->primitives[solid.triangles[i]]);
    return faces * static_cast<double>(face_step) + triangles * static_cast<double>(triangle_step);
}

}  // namespace

double covered(const Figure::Panel& content, const Layout::Panel& panel, const Layout& layout, const Font& font,
               const Rect& box) {
    const double line_weight = 3, mark_weight = 10, label_weight = 150, inset_weight = 1e6;
    const DrawList& list = content.list;
    double sum = content.solid ? covered_by_solid(*content.solid, world_on_page(list, panel, layout.scale), box) : 0;
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
    for (const PlacedInset& inset : place_insets(content, panel, layout, font))
        if (inset.box.overlaps(box)) sum += inset_weight;
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
                    sum += covered(pages[p].panels[i], layouts[p].panels[i], layouts[p], font, box.grown(2));
            if (least < 0 || sum < least) {
                least = sum;
                best = box;
            }
        }
    }
    return best;
}

}  // namespace sightline
