// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/label_place.h"

#include <algorithm>
#include <cmath>

namespace sightline {

namespace {

double kept_inside(double low, double extent, double frame_low, double frame_high) {
    if (extent > frame_high - frame_low) return (frame_low + frame_high - extent) / 2;
    return std::clamp(low, frame_low, frame_high - extent);
}

}  // namespace

Box<2> label_box(const Label& label, const Vec<2>& point, const LabelSize& size, const Box<2>& frame) {
    Vec<2> centre = point;
    if (label.align == TextAlign::left) centre.x += size.width / 2;
    if (label.align == TextAlign::right) centre.x -= size.width / 2;
    const Vec<2> half(std::max(size.width / 2 + size.margin, size.radius), std::max(size.half_height, size.radius));
    const Vec<2> low(kept_inside(centre.x - half.x, 2 * half.x, frame.min.x, frame.max.x),
                     kept_inside(centre.y - half.y, 2 * half.y, frame.min.y, frame.max.y));
    return {low, low + half * 2.0};
}

Vec<2> leader_start(const Box<2>& box, const Vec<2>& tip) {
    const Vec<2> half = box.extent() / 2.0, d = tip - box.centre();
    const double across = d.x != 0 ? half.x / std::abs(d.x) : 1, along = d.y != 0 ? half.y / std::abs(d.y) : 1;
    return box.centre() + d * std::min({across, along, 1.0});
}

}  // namespace sightline
