// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>

#include "core/methods/cells/facet_geometry.h"
#include "core/methods/transmittance/opacity.h"

namespace sightline {

namespace {

/// Samples along a side of the rectangle around the outline.
constexpr int samples = 16;

/// A plane of samples across a direction. A point p lies at column dot(right, p) - left, row dot(up, p) - bottom, and
/// at depth dot(towards, p).
struct SamplePlane {
    Vec<3> towards, right, up;
    double left = 0, bottom = 0;

    SamplePlane(const CellComplex<3>& cells, std::uint32_t cell, const Vec<3>& to_eye) : towards(to_eye) {
        const Vec<3> other = std::abs(to_eye.z) < 0.9 ? Vec<3>(0, 0, 1) : Vec<3>(1, 0, 0);
        right = glm::cross(to_eye, other);
        right /= std::sqrt(glm::dot(right, right));
        up = glm::cross(to_eye, right);
        Box<2> around;
        for (const std::uint32_t corner : cells.corners_of(cell))
            around.add({glm::dot(right, cells.points[corner]), glm::dot(up, cells.points[corner])});
        const Vec<2> size = around.extent();
        if (!(size.x > 0 && size.y > 0)) {
            right = up = Vec<3>(0);
            return;
        }
        right *= samples / size.x;
        up *= samples / size.y;
        left = around.min.x * samples / size.x;
        bottom = around.min.y * samples / size.y;
    }
    bool empty() const { return right == Vec<3>(0); }
    /// (column, row, depth)
    Vec<3> project(const Vec<3>& p) const {
        return {glm::dot(right, p) - left, glm::dot(up, p) - bottom, glm::dot(towards, p)};
    }
};

/// A linear function of column and row.
struct Linear {
    double at = 0, by_column = 0, by_row = 0;
    double value(int column, int row) const { return at + by_column * (column + 0.5) + by_row * (row + 0.5); }
};

/// The depth in the plane of three projected points, `area` being twice theirs in the samples' plane.
Linear depth_of(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, double area) {
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const double by_column = (uz * vy - vz * uy) / area, by_row = (ux * vz - vx * uz) / area;
    return {a.z - by_column * a.x - by_row * a.y, by_column, by_row};
}

double area_of(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Between which depths a ray through each sample lies in the cell; outside the outline between none.
struct Depths {
    std::array<double, samples * samples> from, to;
    int inside = 0;     ///< samples of the outline
    double margin = 0;  ///< far more than depths are off: what lies in a facet belongs to the cells on both its sides

    bool hold(std::size_t sample, double depth) const {
        return depth >= from[sample] - margin && depth <= to[sample] + margin;
    }

    Depths(const CellComplex<3>& cells, std::uint32_t cell, const SamplePlane& plane) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        from.fill(-infinity);
        to.fill(infinity);
        for (const HalfFacet& half : cells.facets_of(cell)) {
            if (cells.is_contact(half.facet())) continue;
            const FacetGeometry<3> facet = facet_geometry(cells, half);
            const auto polygon = cells.points_of_facet(half.facet());
            const Vec<3> a = plane.project(cells.points[polygon[0]]), b = plane.project(cells.points[polygon[1]]),
                         c = plane.project(cells.points[polygon[2]]);
            const double along = glm::dot(facet.normal, plane.towards), area = area_of(a, b, c);
            if (along == 0 || area == 0) {
                cut_edge_on(a, b, c, plane.project(cells.centre(cell)));
                continue;
            }
            const Linear depth = depth_of(a, b, c, area);
            for (int row = 0; row < samples; ++row)
                for (int column = 0; column < samples; ++column) {
                    const auto i = static_cast<std::size_t>(row * samples + column);
                    if (along > 0)
                        to[i] = std::min(to[i], depth.value(column, row));
                    else
                        from[i] = std::max(from[i], depth.value(column, row));
                }
        }
        for (std::size_t i = 0; i < from.size(); ++i) inside += from[i] < to[i];
        for (const std::uint32_t corner : cells.corners_of(cell))
            margin = std::max(margin, 0x1p-40 * std::abs(plane.project(cells.points[corner]).z));
    }

private:
    /// What lies beyond a facet that is seen as a line is outside.
    void cut_edge_on(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& centre) {
        Vec<2> p(a), q(b);
        if (p == q) q = Vec<2>(c);
        const Vec<2> along = q - p;
        const double side = cross(along, Vec<2>(centre) - p);
        if (side == 0) return;
        for (int row = 0; row < samples; ++row)
            for (int column = 0; column < samples; ++column)
                if (cross(along, Vec<2>(column + 0.5, row + 0.5) - p) * side < 0)
                    to[static_cast<std::size_t>(row * samples + column)] = -std::numeric_limits<double>::infinity();
    }
};

int first_sample(double at) { return static_cast<int>(std::ceil(std::clamp(at - 0.5, 0.0, 1.0 * samples))); }
int end_sample(double at) { return static_cast<int>(std::floor(std::clamp(at - 0.5, -1.0, samples - 1.0))) + 1; }

/// Marks the samples that the triangle covers inside the cell.
void cover(const SamplePlane& plane, const Depths& depths, const Primitive<3>& triangle, bool two_sided,
           std::array<std::uint8_t, samples * samples>& covered) {
    const Vec<3> a = plane.project(triangle[0]), b = plane.project(triangle[1]), c = plane.project(triangle[2]);
    double area = area_of(a, b, c);
    // Right, up and towards turn like the axes: a triangle that is seen counter-clockwise faces the eye.
    if (area == 0 || (area < 0 && !two_sided)) return;
    const Linear depth = depth_of(a, b, c, area);
    const double sign = area < 0 ? -1 : 1;
    const std::array<Vec<3>, 3> corners{a, b, c};
    std::array<Linear, 3> edges;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec<3>&p = corners[i], &q = corners[(i + 1) % 3];
        const double x = sign * (q.x - p.x), y = sign * (q.y - p.y);
        edges[i] = {y * p.x - x * p.y, -y, x};
    }
    const int left = first_sample(std::min({a.x, b.x, c.x})), right = end_sample(std::max({a.x, b.x, c.x}));
    const int bottom = first_sample(std::min({a.y, b.y, c.y})), top = end_sample(std::max({a.y, b.y, c.y}));
    for (int row = bottom; row < top; ++row)
        for (int column = left; column < right; ++column) {
            const auto i = static_cast<std::size_t>(row * samples + column);
            if (covered[i]) continue;
            if (edges[0].value(column, row) < 0 || edges[1].value(column, row) < 0 || edges[2].value(column, row) < 0)
                continue;
            covered[i] = depths.hold(i, depth.value(column, row));
        }
}

}  // namespace

double covered_share(const Scene<3>& scene, const CellComplex<3>& cells, std::uint32_t cell, const Vec<3>& to_eye) {
    const SamplePlane plane(cells, cell, to_eye);
    if (plane.empty()) return 0;
    const Depths depths(cells, cell, plane);
    if (depths.inside == 0) return 0;
    std::array<std::uint8_t, samples * samples> covered{};
    for (const std::uint32_t primitive : cells.primitives_of(cell))
        cover(plane, depths, scene.primitives[primitive], shows_both_sides(scene, primitive), covered);
    int count = 0;
    for (std::size_t i = 0; i < covered.size(); ++i) count += covered[i] && depths.from[i] < depths.to[i];
    return static_cast<double>(count) / depths.inside;
}

}  // namespace sightline
