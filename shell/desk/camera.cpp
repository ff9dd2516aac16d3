// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/camera.h"

#include <algorithm>

#include "core/base/trig.h"
#include "core/scene/view.h"

namespace sightline {

namespace {

/// Degrees from straight up or down at which turning stops: at the pole the picture would flip.
constexpr double pole_margin = 1;

Vec<3> unit(const Vec<3>& v) { return v / std::sqrt(glm::dot(v, v)); }

/// `v` turned by degrees about a unit vector, counter-clockwise as the vector's tip sees it.
Vec<3> rotated(const Vec<3>& v, const Vec<3>& axis, double degrees) {
    const SinCos t = sincos_degrees(degrees);
    return v * t.cos + glm::cross(axis, v) * t.sin + axis * (glm::dot(axis, v) * (1 - t.cos));
}

/// The direction turned to the right and upwards.
Vec<3> turned_direction(const Vec<3>& direction, int up_axis, double right, double up) {
    Vec<3> world_up(0);
    world_up[up_axis] = 1;
    const double length = std::sqrt(glm::dot(direction, direction));
    const double flat = std::sqrt(std::max(0.0, length * length - direction[up_axis] * direction[up_axis]));
    const double height = angle_of(direction[up_axis], flat) * 180 / pi;
    const double to = std::clamp(height + up, std::min(height, -90 + pole_margin), std::max(height, 90 - pole_margin));
    Vec<3> side = glm::cross(direction, world_up);
    if (glm::dot(side, side) < 1e-24 * length * length) side = up_axis == 0 ? Vec<3>(0, 1, 0) : Vec<3>(1, 0, 0);
    return rotated(rotated(direction, unit(side), to - height), world_up, -right);
}

}  // namespace

Axes axes(const ViewSpec<3>& view, int up_axis) {
    Vec<3> up_hint(0);
    const Vec<3> forward = unit(view.look_at - view.eye);
    up_hint[std::abs(forward[up_axis]) < 0.999999 ? up_axis : other_axis(up_axis)] = 1;
    const Vec<3> right = unit(glm::cross(forward, up_hint));
    return {forward, right, glm::cross(right, forward)};
}

ViewSpec<3> orbited(const ViewSpec<3>& view, int up_axis, double right, double up) {
    // The eye to the right: the view turns to the left.
    return {view.look_at - turned_direction(view.look_at - view.eye, up_axis, -right, -up), view.look_at, view.fov};
}

ViewSpec<3> turned(const ViewSpec<3>& view, int up_axis, double right, double up) {
    return {view.eye, view.eye + turned_direction(view.look_at - view.eye, up_axis, right, up), view.fov};
}

ViewSpec<3> walked(const ViewSpec<3>& view, int up_axis, const Vec<3>& right_up_forward) {
    const Axes a = axes(view, up_axis);
    const Vec<3> by = a.right * right_up_forward.x + a.up * right_up_forward.y + a.forward * right_up_forward.z;
    return {view.eye + by, view.look_at + by, view.fov};
}

ViewSpec<3> approached(const ViewSpec<3>& view, double factor) {
    return {view.look_at + (view.eye - view.look_at) / factor, view.look_at, view.fov};
}

ViewSpec<3> outside(const ViewSpec<3>& view, const Box<3>& box, int up_axis, double aspect) {
    const Axes a = axes(view, up_axis);
    const SinCos half = sincos_degrees(view.fov / 2);
    const double tall = half.sin / half.cos, wide = tall * aspect;
    const Vec<3> middle = box.centre();
    double distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec<3> p;
        for (int i = 0; i < 3; ++i) p[i] = (corner >> i & 1 ? box.max : box.min)[i];
        const Vec<3> d = p - middle;
        const double nearer = -glm::dot(d, a.forward);
        distance = std::max(
            {distance, nearer + std::abs(glm::dot(d, a.up)) / tall, nearer + std::abs(glm::dot(d, a.right)) / wide});
    }
    distance = std::max(distance * 1.05, 1e-6);  // some air about it
    return {middle - a.forward * distance, middle, view.fov};
}

}  // namespace sightline
