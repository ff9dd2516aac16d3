// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/picking_3d.h"

#include <limits>

#include "core/draw/projection.h"
#include "core/geometry/hit_triangle.h"

namespace sightline {

Ray3d ray_through(const View<3>& view, const Vec<2>& plane) {
    const double width = picture_plane(view).max.x;
    const Vec<3> through = view.corners[0] + (view.corners[1] - view.corners[0]) * (plane.x / width) +
                           (view.corners[3] - view.corners[0]) * plane.y;
    return {view.eye, through - view.eye};
}

Pick3d pick(const SolidList& list, const Vec<2>& plane) {
    const Ray3d ray = ray_through(list.camera, plane);
    constexpr double far = std::numeric_limits<double>::infinity();
    double nearest_face = far, nearest_triangle = far;
    Pick3d found;
    for (std::size_t face = 0; face + 1 < list.face_begin.size(); ++face) {
        const std::uint32_t first = list.face_begin[face], end = list.face_begin[face + 1];
        for (std::uint32_t i = first + 1; i + 1 < end; ++i)
            if (const auto t =
                    hit_triangle(ray.from, ray.along, list.points[first], list.points[i], list.points[i + 1]);
                t && *t < nearest_face) {
                nearest_face = *t;
                found.cell = list.face_cell[face];
            }
    }
    for (const SolidList::Run& run : list.runs)
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            const auto& [a, b, c] = list.scene->primitives[list.triangles[i]];
            const auto t = hit_triangle(ray.from, ray.along, a, b, c);
            if (!t || *t >= nearest_triangle) continue;
            if (list.slice && glm::dot(list.slice->normal, ray.from + ray.along * *t) > list.slice->offset) continue;
            nearest_triangle = *t;
            found.primitive = list.triangles[i] < list.levels_from ? list.triangles[i] : none;
        }
    const double nearest = std::min(nearest_face, nearest_triangle);
    if (nearest < far) found.point = ray.from + ray.along * nearest;
    return found;
}

std::uint32_t cell_along(const CellComplex<3>& cells, std::span<const std::uint32_t> among, const Ray3d& ray) {
    double nearest = std::numeric_limits<double>::infinity();
    std::uint32_t found = none;
    for (const std::uint32_t cell : among)
        for (const HalfFacet& half : cells.facets_of(cell)) {
            const auto polygon = cells.points_of_facet(half.facet());
            for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
                if (const auto t = hit_triangle(ray.from, ray.along, cells.points[polygon[0]], cells.points[polygon[i]],
                                                cells.points[polygon[i + 1]]);
                    t && *t < nearest) {
                    nearest = *t;
                    found = cell;
                }
        }
    return found;
}

}  // namespace sightline
