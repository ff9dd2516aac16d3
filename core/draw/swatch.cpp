// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/swatch.h"

#include <algorithm>

namespace sightline {

Swatch swatch_of(const LegendRow& row, const Box<2>& box, double text_pt) {
    const Vec<2>&low = box.min, &high = box.max;
    const Vec<2> centre = box.centre();
    switch (row.swatch) {
        case ShapeKind::polygon:
            return {{low, {high.x, low.y}, high, {low.x, high.y}}};
        case ShapeKind::polyline:
            return {{{low.x, centre.y}, {high.x, centre.y}}};
        case ShapeKind::arrow:
            return {{{low.x, centre.y}, {high.x, centre.y}}, std::max(0.6 * text_pt, 3 * row.style.width_pt)};
        default:
            return {{centre}, 0.36 * text_pt};
    }
}

}  // namespace sightline
