// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/image_triangles.h"

#include <span>

namespace sightline {

namespace {

/// How far a rasteriser may move a corner, in pixels: to the next of 256 places, and a little for floats.
constexpr double snap = 1.0 / 128;

/// Points of the image as (x w, y w, w); what is in front of the eye is where they turn positive by w.
using Polygon = std::array<Vec<3>, 7>;

/// Cuts a convex polygon to the side where sign * p[axis] <= cone_reach * w. An edge is cut from its inner end, so that
/// both triangles that share it get the same point.
std::size_t cut(std::span<const Vec<3>> polygon, int axis, double sign, Polygon& inside) {
    std::size_t count = 0;
    const auto depth = [&](const Vec<3>& p) { return cone_reach * p.z - sign * p[axis]; };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<3>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double in_a = depth(a), in_b = depth(b);
        if (in_a >= 0) inside[count++] = a;
        if (in_a > 0 && in_b < 0) inside[count++] = a + (b - a) * (in_a / (in_a - in_b));
        if (in_b > 0 && in_a < 0) inside[count++] = b + (a - b) * (in_b / (in_b - in_a));
    }
    return count;
}

/// The part of the triangle in the widened cone. Its four sides leave nothing behind the eye.
std::size_t cut_to_cone(const std::array<Vec<3>, 3>& triangle, Polygon& polygon) {
    Polygon other;
    std::size_t count = cut(triangle, 0, 1, other);
    count = cut(std::span(other).first(count), 0, -1, polygon);
    count = cut(std::span(polygon).first(count), 1, 1, other);
    return cut(std::span(other).first(count), 1, -1, polygon);
}

/// Whether all three lie beyond one side of the cone itself.
bool beyond(const std::array<Vec<3>, 3>& p) {
    const auto all = [&](const auto& outside) { return outside(p[0]) && outside(p[1]) && outside(p[2]); };
    return all([](const Vec<3>& q) { return q.x > q.z; }) || all([](const Vec<3>& q) { return -q.x > q.z; }) ||
           all([](const Vec<3>& q) { return q.y > q.z; }) || all([](const Vec<3>& q) { return -q.y > q.z; });
}

bool within_reach(const std::array<Vec<3>, 3>& p) {
    for (const Vec<3>& q : p)
        if (!(std::max(std::abs(q.x), std::abs(q.y)) <= cone_reach * q.z)) return false;
    return true;
}

/// Whether a pixel's centre lies in the range from low to high (-1 to 1) of `pixels` pixels, or close to it.
bool meets_centre(double low, double high, int pixels) {
    const double scale = pixels * 0.5;
    const double first = std::ceil((low + 1) * scale - 0.5 - snap), last = std::floor((high + 1) * scale - 0.5 + snap);
    return std::max(first, 0.0) <= std::min(last, pixels - 1.0);
}

bool meets_centre(std::span<const Vec<3>> seen, const ImageSize& size) {
    Box<2> box;
    for (const Vec<3>& p : seen) box.add({p.x, p.y});
    return meets_centre(box.min.x, box.max.x, size.width) && meets_centre(box.min.y, box.max.y, size.height);
}

}  // namespace

void append_image_triangle(const Scene<3>& scene, const View<3>& view, const ImagePlane& plane, const ImageSize& size,
                           std::size_t primitive, std::vector<ImageCorner>& corners) {
    const Primitive<3>& triangle = scene.primitives[primitive];
    const std::array<Vec<3>, 3> projected{plane.project(triangle[0]), plane.project(triangle[1]),
                                          plane.project(triangle[2])};
    if (beyond(projected)) return;
    const int side = orient(triangle[0], triangle[1], triangle[2], view.eye);
    // Edge-on: what the image then shows of it is rounding.
    if (side == 0 || (side < 0 && !shows_both_sides(scene, primitive))) return;
    Polygon polygon;
    std::size_t count = 3;
    if (within_reach(projected))
        std::copy(projected.begin(), projected.end(), polygon.begin());
    else
        count = cut_to_cone(projected, polygon);
    const auto seen = std::span(polygon).first(count);
    // Only one that holds the eye comes so near; it is seen edge-on.
    if (std::any_of(seen.begin(), seen.end(), [](const Vec<3>& p) { return !(p.z > nearness_1); })) return;
    for (Vec<3>& p : seen) p = {p.x / p.z, -p.y / p.z, nearness_1 / p.z};
    if (!meets_centre(seen, size)) return;
    const auto append = [&](const Vec<3>& p) {
        corners.push_back({static_cast<float>(p.x), static_cast<float>(p.y),
                           static_cast<float>(std::max(p.z, 0x1p-126)), static_cast<std::uint32_t>(primitive)});
    };
    for (std::size_t i = 2; i < count; ++i) {
        append(seen[0]);
        append(seen[i - 1]);
        append(seen[i]);
    }
}

void append_image_triangles(const Scene<3>& scene, const View<3>& view, const ImageSize& size, std::size_t& next,
                            std::size_t limit, std::vector<ImageCorner>& corners) {
    const ImagePlane plane = image_plane(view);
    for (; next < scene.primitives.size() && corners.size() < limit; ++next)
        append_image_triangle(scene, view, plane, size, next, corners);
}

}  // namespace sightline
