// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/seen_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sightline {

namespace {

/// A step of a float, and the rounding of the corners' nearness: 2^-23 and a little.
constexpr double depth_step = 1 + 0x1p-22;

using Points = std::vector<Vec<3>>;  ///< as (x w, y w, w)

Points cut_to(const Points& polygon, int axis, double sign) {
    Points inside;
    const auto depth = [&](const Vec<3>& p) { return cone_reach * p.z - sign * p[axis]; };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<3>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double in_a = depth(a), in_b = depth(b);
        if (in_a >= 0) inside.push_back(a);
        if ((in_a > 0 && in_b < 0) || (in_a < 0 && in_b > 0)) inside.push_back(a + (b - a) * (in_a / (in_a - in_b)));
    }
    return inside;
}

double size_of(const Vec<3>& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

class Outline {
public:
    Outline(const View<3>& view, const ImageSize& size) : view_(view), plane_(image_plane(view)), size_(size) {}

    void add(SeenShape& shape, std::span<const Vec<3>> corners) const {
        const int turn = orient(corners[0], corners[1], corners[2], view_.eye);
        if (turn == 0) return;
        Points whole;
        double extent = 0;
        for (const Vec<3>& corner : corners) {
            whole.push_back(plane_.project(corner));
            extent = std::max(extent, size_of(whole.back()));
        }
        if (turn > 0) std::reverse(whole.begin(), whole.end());  // y turns downwards
        Points seen = whole;
        for (const int axis : {0, 1})
            for (const double sign : {1.0, -1.0}) seen = cut_to(seen, axis, sign);
        if (seen.size() < 3) return;
        double nearest = 0;
        // Closer to the eye than this share of its size, rounding moves points in the image.
        for (const Vec<3>& p : seen) {
            if (!(p.z > 0x1p-30 * extent)) {
                shape.everywhere = true;
                return;
            }
            nearest = std::max(nearest, 1 / p.z);
        }
        SeenFace face;
        face.nearest = nearest * nearness_1 * depth_step;
        if (!give_edges(face, seen)) return;
        give_depth(face, whole);
        shape.faces.push_back(std::move(face));
    }

private:
    Vec<2> pixel(const Vec<3>& p) const {
        return {(p.x / p.z + 1) * 0.5 * size_.width, (1 - p.y / p.z) * 0.5 * size_.height};
    }

    /// False where it covers no pixel of the image.
    bool give_edges(SeenFace& face, const Points& seen) const {
        Box<2> box;
        for (const Vec<3>& p : seen) box.add(pixel(p));
        const auto first = [](double low) { return std::max(0.0, std::ceil(low - 0.5 - query_margin)); };
        const auto end = [](double high, int pixels) {
            return std::min<double>(pixels, std::floor(high - 0.5 + query_margin) + 1);
        };
        const double left = first(box.min.x), right = end(box.max.x, size_.width), top = first(box.min.y),
                     bottom = end(box.max.y, size_.height);
        if (!(left < right && top < bottom)) return false;
        face.left = static_cast<int>(left);
        face.right = static_cast<int>(right);
        face.top = static_cast<int>(top);
        face.bottom = static_cast<int>(bottom);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Vec<2> a = pixel(seen[i]), d = pixel(seen[(i + 1) % seen.size()]) - a;
            const double length = std::abs(d.x) + std::abs(d.y);
            if (length < 1.0 / 1024) continue;  // where it runs is rounding; the others and the box say enough
            face.edges.push_back({-d.y, d.x, d.x * (0.5 - a.y) - d.y * (0.5 - a.x) + query_margin * length});
        }
        return true;
    }

    /// Leaves it as near everywhere as at the nearest point where it is seen too close to edge-on for doubles.
    void give_depth(SeenFace& face, const Points& whole) const {
        face.nearness_0 = face.nearest;
        const Vec<3> u = whole[1] - whole[0], v = whole.back() - whole[0], normal = glm::cross(u, v);
        const double turned = glm::dot(normal, whole[0]);
        // What rounding of the corners may change of the normal.
        const double unsure = 0x1p-48 * size_of(u) * size_of(v);
        if (!(std::abs(turned) > 0x1p24 * unsure * size_of(whole[0]))) return;
        // One over w is normal * (x, y, 1) / turned, for x and y from -1 to 1.
        const double x = normal.x / turned * 2 / size_.width, y = -normal.y / turned * 2 / size_.height,
                     at = (normal.z - normal.x + normal.y) / turned + 0.5 * (x + y);
        const double more = (std::abs(x) + std::abs(y)) * query_margin + 4 * unsure / std::abs(turned);
        face.nearness_0 = (at + more) * nearness_1 * depth_step;
        face.nearness_x = x * nearness_1 * depth_step;
        face.nearness_y = y * nearness_1 * depth_step;
    }

    const View<3>& view_;
    ImagePlane plane_;
    ImageSize size_;
};

}  // namespace

bool SeenFace::misses(int x, int y, int end_x, int end_y) const {
    if (end_x <= left || x >= right || end_y <= top || y >= bottom) return true;
    for (const Edge& e : edges)
        if (e.a * (e.a > 0 ? end_x - 1 : x) + e.b * (e.b > 0 ? end_y - 1 : y) + e.c < 0) return true;
    return false;
}

double SeenFace::nearness(int x, int y, int end_x, int end_y) const {
    return nearness(nearness_x > 0 ? end_x - 1 : x, nearness_y > 0 ? end_y - 1 : y);
}

SeenShape seen_box(const View<3>& view, const ImageSize& size, const Box<3>& box) {
    SeenShape shape;
    if (box.empty()) return shape;
    if (box.contains(view.eye)) {
        shape.everywhere = true;
        return shape;
    }
    const Outline outline(view, size);
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            const double at = high ? box.max[axis] : box.min[axis];
            if (high ? view.eye[axis] <= at : view.eye[axis] >= at) continue;
            std::array<Vec<3>, 4> corners;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i][axis] = at;
                corners[i][u] = i == 1 || i == 2 ? box.max[u] : box.min[u];
                corners[i][v] = i >= 2 ? box.max[v] : box.min[v];
            }
            outline.add(shape, corners);
        }
    return shape;
}

SeenShape seen_cell(const View<3>& view, const ImageSize& size, const CellComplex<3>& cells, std::uint32_t cell) {
    SeenShape shape;
    const Outline outline(view, size);
    bool inside = true;
    for (const HalfFacet& half : cells.facets_of(cell)) {
        const int side = facet_side(cells, half, view.eye);
        inside &= side >= 0;
        if (side >= 0) continue;
        std::vector<Vec<3>> corners;
        for (const std::uint32_t point : cells.points_of_facet(half.facet())) corners.push_back(cells.points[point]);
        outline.add(shape, corners);
    }
    shape.everywhere |= inside;
    return shape;
}

SeenShape seen_polygon(const View<3>& view, const ImageSize& size, std::span<const Vec<3>> corners) {
    SeenShape shape;
    if (corners.size() >= 3) Outline(view, size).add(shape, corners);
    return shape;
}

}  // namespace sightline
