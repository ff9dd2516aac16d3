// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window/variant_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sightline {

namespace {

/// A regular polygon of `count` corners, the first in that direction, in turns from the right, downwards.
std::vector<ImVec2> polygon(const ImVec2& centre, float radius, int count, float turn) {
    std::vector<ImVec2> corners;
    for (int i = 0; i < count; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * (turn + static_cast<float>(i) / static_cast<float>(count));
        corners.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return corners;
}

/// Empty: a circle.
std::vector<ImVec2> corners(ChartMarker marker, const ImVec2& c, float r) {
    switch (marker) {
        case ChartMarker::circle:
            return {};
        case ChartMarker::square:
            return polygon(c, 1.15f * r, 4, 0.125f);
        case ChartMarker::triangle:
            return polygon(c, 1.3f * r, 3, -0.25f);
        case ChartMarker::diamond:
            return polygon(c, 1.25f * r, 4, 0);
        case ChartMarker::triangle_down:
            return polygon(c, 1.3f * r, 3, 0.25f);
        case ChartMarker::pentagon:
            return polygon(c, 1.15f * r, 5, -0.25f);
    }
    return {};
}

}  // namespace

void draw_line(ImDrawList& list, std::span<const ImVec2> points, const VariantLook& look, float width) {
    const ImU32 c = colour(look.colour);
    if (look.dash.empty()) {
        list.AddPolyline(points.data(), static_cast<int>(points.size()), c, 0, width);
        return;
    }
    std::size_t piece = 0;
    float left = look.dash[0] * width;  // of the piece that a stretch begins in
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const ImVec2 a = points[i], b = points[i + 1];
        const float length = std::hypot(b.x - a.x, b.y - a.y);
        for (float at = 0; at < length;) {
            const float to = std::min(at + left, length), s = at / length, t = to / length;
            if (piece % 2 == 0)
                list.AddLine({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)},
                             {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, c, width);
            left -= to - at;
            if (to < length || left <= 0) {
                piece = (piece + 1) % look.dash.size();
                left = look.dash[piece] * width;
            }
            at = to;
        }
    }
}

void draw_marker(ImDrawList& list, const ImVec2& centre, const VariantLook& look, float radius, const Colour& paper) {
    const ImU32 c = colour(look.colour), fill = look.filled ? c : colour(paper);
    const float width = 0.35f * radius;
    const std::vector<ImVec2> at = corners(look.marker, centre, radius);
    if (at.empty()) {
        list.AddCircleFilled(centre, radius, fill);
        if (!look.filled) list.AddCircle(centre, radius, c, 0, width);
        return;
    }
    list.AddConvexPolyFilled(at.data(), static_cast<int>(at.size()), fill);
    if (!look.filled) list.AddPolyline(at.data(), static_cast<int>(at.size()), c, ImDrawFlags_Closed, width);
}

}  // namespace sightline
