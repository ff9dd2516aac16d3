// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/picking3d.h"

#include <limits>
#include <optional>

#include "core/draw/projection.h"

namespace sightline {

namespace {

/// Where the ray, in multiples of its direction, meets a triangle (Möller and Trumbore, 1997); nothing behind the eye.
std::optional<double> hit(const Ray3d& ray, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
    const Vec<3> ab = b - a, ac = c - a, p = glm::cross(ray.along, ac);
    const double det = glm::dot(ab, p);
    if (det == 0) return std::nullopt;
    const Vec<3> s = ray.from - a;
    const double u = glm::dot(s, p) / det;
    if (!(u >= 0 && u <= 1)) return std::nullopt;
    const Vec<3> q = glm::cross(s, ab);
    const double v = glm::dot(ray.along, q) / det;
    if (!(v >= 0 && u + v <= 1)) return std::nullopt;
    const double t = glm::dot(ac, q) / det;
    return t > 0 ? std::optional(t) : std::nullopt;
}

}  // namespace

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
            if (const auto t = hit(ray, list.points[first], list.points[i], list.points[i + 1]);
                t && *t < nearest_face) {
                nearest_face = *t;
                found.cell = list.face_cell[face];
            }
    }
    for (const SolidList::Run& run : list.runs)
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            const auto& [a, b, c] = list.scene->primitives[list.triangles[i]];
            const auto t = hit(ray, a, b, c);
            if (!t || *t >= nearest_triangle) continue;
            if (list.slice && glm::dot(list.slice->normal, ray.from + ray.along * *t) > list.slice->offset) continue;
            nearest_triangle = *t;
            found.primitive = list.triangles[i];
        }
    const double nearest = std::min(nearest_face, nearest_triangle);
    if (nearest < far) found.point = ray.from + ray.along * nearest;
    return found;
}

}  // namespace sightline
