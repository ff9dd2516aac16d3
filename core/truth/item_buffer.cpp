// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/truth/item_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/geometry/predicates.h"

namespace sightline {

namespace {

/// An image line: the points right + s (left - right) from the eye, 0 <= s <= 1.
struct Camera {
    Vec<2> right, left;
};

/// A point in homogeneous image coordinates: it lies at s = sw / w, and w is its depth, in units of the line's depth.
struct Projected {
    double sw, w;
};

Projected project(const Camera& camera, const Vec<2>& p) {
    const double whole = cross(camera.right, camera.left);
    return {cross(camera.right, p) / whole, cross(p, camera.left - camera.right) / whole};
}

/// One over the depth as a function of s: at + slope (s - origin).
struct InverseDepth {
    double origin, at, slope;
    double operator()(double s) const { return at + slope * (s - origin); }
};

/// What a segment covers of an image line, from `begin` to `end` in s.
struct Footprint {
    double begin, end;
    InverseDepth inverse_depth;
};

/// The footprint of a segment that turns counter-clockwise about the eye from a to b; empty when behind the eye.
Footprint footprint(const Projected& a, const Projected& b) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (a.w > 0 && b.w > 0) {
        const double begin = a.sw / a.w, end = b.sw / b.w;
        return {begin, end, {begin, 1 / a.w, (1 / b.w - 1 / a.w) / (end - begin)}};
    }
    if (!(a.w > 0 || b.w > 0)) return {0, 0, {}};
    // Cut at the eye plane, where s goes to infinity. Divided by the size, products neither underflow nor overflow.
    const double size = std::max({std::abs(a.w), std::abs(b.w), std::abs(a.sw), std::abs(b.sw)});
    const double turn = (a.w / size) * (b.sw / size) - (a.sw / size) * (b.w / size);
    if (!(turn > 0)) return {0, 0, {}};  // through the eye but for rounding
    const double slope = (a.w / size - b.w / size) / turn / size;
    if (a.w > 0) return {a.sw / a.w, infinity, {a.sw / a.w, 1 / a.w, slope}};
    return {-infinity, b.sw / b.w, {b.sw / b.w, 1 / b.w, slope}};
}

/// The first of `width` pixels whose centre is at s or beyond.
int first_pixel(double s, int width) {
    return static_cast<int>(std::clamp(std::ceil(s * width - 0.5), 0.0, static_cast<double>(width)));
}

void draw(std::span<const Primitive<2>> primitives, const Vec<2>& eye, const Camera& camera,
          std::span<std::uint32_t> ids) {
    const int width = static_cast<int>(ids.size());
    std::vector<double> nearest(ids.size(), 0);  // one over the depth
    for (std::size_t k = 0; k < primitives.size(); ++k) {
        const int side = orient(eye, primitives[k][0], primitives[k][1]);
        if (side == 0) continue;
        const Projected a = project(camera, primitives[k][side > 0 ? 0 : 1] - eye);
        const Projected b = project(camera, primitives[k][side > 0 ? 1 : 0] - eye);
        const Footprint seen = footprint(a, b);
        if (!(seen.begin < seen.end)) continue;  // also when not a number
        const int end = first_pixel(seen.end, width);
        for (int i = first_pixel(seen.begin, width); i < end; ++i) {
            const double inverse_depth = seen.inverse_depth((i + 0.5) / width);
            // Ids ascend, so on equal depth the lowest stays.
            if (inverse_depth > nearest[i]) {
                nearest[i] = inverse_depth;
                ids[i] = static_cast<std::uint32_t>(k);
            }
        }
    }
}

}  // namespace

ItemBuffer item_buffer(std::span<const Primitive<2>> primitives, const View<2>& view, int width) {
    if (width < 1 || width > 1 << 24)
        throw InputError("item buffer: width must be in [1, 16777216], not " + std::to_string(width));
    if (view.all_round && width % 4 != 0)
        throw InputError("item buffer: width of an all-round view must be a multiple of 4, not " +
                         std::to_string(width));
    ItemBuffer buffer{std::vector<std::uint32_t>(width, none)};
    const std::span<std::uint32_t> ids(buffer.ids);
    if (view.all_round) {
        const std::array<Vec<2>, 4> corners{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
        const std::size_t quarter = ids.size() / 4;
        for (std::size_t side = 0; side < 4; ++side)
            draw(primitives, view.eye, {corners[side], corners[(side + 1) % 4]}, ids.subspan(side * quarter, quarter));
    } else {
        // Brought to unit size, so that products of small distances do not vanish.
        const Vec<2> right = view.corners[0] - view.eye, left = view.corners[1] - view.eye;
        const double size = std::max({std::abs(right.x), std::abs(right.y), std::abs(left.x), std::abs(left.y)});
        draw(primitives, view.eye, {right / size, left / size}, ids);
    }
    return buffer;
}

std::vector<std::uint8_t> visible_in(const ItemBuffer& buffer, std::size_t primitive_count) {
    std::vector<std::uint8_t> visible(primitive_count, 0);
    for (const std::uint32_t id : buffer.ids)
        if (id != none) visible[id] = 1;
    return visible;
}

}  // namespace sightline
