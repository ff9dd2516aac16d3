// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/method_looks.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/base/quote.h"

namespace sightline::lab {

namespace {

/// The corners of a marker, in its own size; empty: a circle.
std::string corners(ChartMarker marker) {
    switch (marker) {
        case ChartMarker::circle:
            return {};
        case ChartMarker::square:
            return "-3,-3 3,-3 3,3 -3,3";
        case ChartMarker::triangle:
            return "0,-4 3.6,2.6 -3.6,2.6";
        case ChartMarker::diamond:
            return "0,-4.2 4.2,0 0,4.2 -4.2,0";
        case ChartMarker::triangle_down:
            return "0,4 3.6,-2.6 -3.6,-2.6";
        case ChartMarker::pentagon:
            return "0,-3.9 3.7,-1.2 2.3,3.2 -2.3,3.2 -3.7,-1.2";
    }
    return {};
}

}  // namespace

MethodLooks::MethodLooks(const std::vector<MethodChoice>& methods) {
    for (const MethodChoice& method : methods) variants_.push_back(method.variant);
    looks_ = variant_looks(variants_);
}

VariantLook MethodLooks::look(const MethodChoice& method) const {
    const auto at = std::find(variants_.begin(), variants_.end(), method.variant);
    VariantLook look = at == variants_.end() ? variant_looks({&method.variant, 1}).front()
                                             : looks_[static_cast<std::size_t>(at - variants_.begin())];
    look.filled = method.tessellation == Tessellation::delaunay;
    return look;
}

Series MethodLooks::series(const MethodChoice& method) const {
    return {method_text(method), look(method), {}, 2, {}, {}};
}

std::string MethodLooks::cell(const MethodChoice& method) const {
    return "<td class=t>" + swatch(look(method)) + escaped(method_text(method)) + "</td>";
}

std::string swatch(const VariantLook& look) {
    const std::string colour = hex_colour(look.colour);
    std::string dash;
    for (const float length : look.dash) dash += (dash.empty() ? "" : " ") + short_number(1.5 * length);
    const std::string points = corners(look.marker);
    const std::string marker = points.empty() ? "<circle r='3.3'" : "<polygon points='" + points + "'";
    return "<svg class=swatch width='34' height='12' viewBox='-17 -6 34 12'><path d='M-17,0H17' fill='none' stroke='" +
           colour + "' stroke-width='1.5'" + (dash.empty() ? "" : " stroke-dasharray='" + dash + "'") + "/>" + marker +
           " stroke='" + colour + "' fill='" + (look.filled ? colour : "#fff") + "'/></svg> ";
}

}  // namespace sightline::lab
