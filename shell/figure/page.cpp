// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/figure/page.h"

#include <algorithm>
#include <cmath>

#include "core/draw/solid_list.h"

namespace sightline {

PixelRect pixel_rect(const Rect& rect, double px_per_pt) {
    const double scale = std::min(px_per_pt, largest_solid_picture / std::max(rect.w, rect.h));
    const double left = std::round(rect.x * scale), top = std::round(rect.y * scale);
    const auto pixels = [](double from, double to) {
        return std::clamp(static_cast<int>(std::round(to) - from), 1, largest_solid_picture);
    };
    const int w = pixels(left, rect.right() * scale), h = pixels(top, rect.bottom() * scale);
    return {w, h, scale, {left / scale, top / scale, w / scale, h / scale}};
}

}  // namespace sightline
