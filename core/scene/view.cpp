// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/view.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/trig.h"
#include "core/geometry/predicates.h"

namespace sightline {

namespace {

template <int D>
void check(const ViewSpec<D>& spec) {
    if (!is_finite(spec.eye) || !is_finite(spec.look_at)) throw InputError("view: eye and look-at must be finite");
    if (spec.eye == spec.look_at) throw InputError("view: look-at coincides with the eye, so there is no direction");
    const bool all_round = D == 2 && spec.fov == 360;
    if (!(spec.fov > 0 && spec.fov < 180) && !all_round)
        throw InputError(D == 2 ? "view: fov must lie strictly between 0 and 180 degrees, or be 360 for all round"
                                : "view: fov must lie strictly between 0 and 180 degrees");
}

/// +1 on the inner side of the cone's right border, 0 on it.
int side_of_right(const View<2>& view, const Vec<2>& p) { return orient(view.eye, view.corners[0], p); }
/// +1 on the inner side of the cone's left border, 0 on it.
int side_of_left(const View<2>& view, const Vec<2>& p) { return -orient(view.eye, view.corners[1], p); }

/// Whether the closed segment ab, whose ends lie on the given sides of the line through the eye and a corner, meets
/// the ray from the eye through that corner.
bool meets_ray(const View<2>& view, int side_a, int side_b, const Vec<2>& a, const Vec<2>& b) {
    if (side_a * side_b > 0 || (side_a == 0 && side_b == 0)) return false;
    const int turn = orient(a, b, view.eye);
    return side_a > side_b ? turn <= 0 : turn >= 0;
}

/// More than products of coordinates lose when they underflow.
constexpr double smallest_product = 1e-300;

/// Whether q, relative to the eye, lies beyond the plane for sure.
bool beyond(const ViewPlane& plane, const Vec<3>& q) {
    return glm::dot(plane.inward, q) < -(glm::dot(plane.uncertainty, glm::abs(q)) + smallest_product);
}

/// The plane through the eye, a and b, with the inner point on its inner side. The exact normal is the cross product of
/// the exact differences; each of its components is computed with an error below 4 u (|p| + |r|), where p and r are its
/// two products and u = 2^-53. A difference q and the three products and two sums with it add less than 4 u to that
/// factor. Twice the sum is kept.
ViewPlane plane_through(const Vec<3>& eye, const Vec<3>& a, const Vec<3>& b, const Vec<3>& inner) {
    const Vec<3> u = a - eye, v = b - eye;
    const Vec<3> p(u.y * v.z, u.z * v.x, u.x * v.y), r(u.z * v.y, u.x * v.z, u.y * v.x);
    // Where the eye, a, b and the inner point lie in one plane after rounding, nothing is outside.
    return {(p - r) * static_cast<double>(orient(eye, a, b, inner)), (glm::abs(p) + glm::abs(r)) * 0x1p-49};
}

}  // namespace

View<2> make_view(const ViewSpec<2>& spec) {
    check(spec);
    View<2> view{spec.eye, spec.look_at, spec.fov, spec.fov == 360, {}, {}};
    if (view.all_round) return view;
    // Of a right angle, the usual one, both are taken as 1: the corners are then exact on a grid of whole numbers.
    const SinCos half = spec.fov == 90 ? SinCos{1, 1} : sincos_degrees(spec.fov / 2);
    const Vec<2> d = spec.look_at - spec.eye;
    view.corners[0] = spec.eye + Vec<2>(half.cos * d.x + half.sin * d.y, half.cos * d.y - half.sin * d.x);
    view.corners[1] = spec.eye + Vec<2>(half.cos * d.x - half.sin * d.y, half.cos * d.y + half.sin * d.x);
    if (orient(view.eye, view.corners[0], view.corners[1]) <= 0)
        throw InputError("view: eye and look-at are so close that the view cone vanishes in rounding");
    return view;
}

View<3> make_view(const ViewSpec<3>& spec, double aspect, int up_axis) {
    check(spec);
    View<3> view{spec.eye, spec.look_at, spec.fov, false, {}, {}};
    const Vec<3> forward = view.forward();
    Vec<3> up_hint(0);
    up_hint[std::abs(forward[up_axis]) < 0.999999 ? up_axis : other_axis(up_axis)] = 1;
    const Vec<3> right =
        glm::cross(forward, up_hint) / std::sqrt(glm::dot(glm::cross(forward, up_hint), glm::cross(forward, up_hint)));
    const Vec<3> up = glm::cross(right, forward);
    const SinCos half = sincos_degrees(spec.fov / 2);
    const double distance = std::sqrt(glm::dot(spec.look_at - spec.eye, spec.look_at - spec.eye));
    const double h = spec.fov == 90 ? distance : distance * half.sin / half.cos, w = h * aspect;
    const Vec<3> centre = spec.look_at;
    view.corners = {centre - right * w - up * h, centre + right * w - up * h, centre + right * w + up * h,
                    centre - right * w + up * h};
    for (const Vec<3>& corner : view.corners)
        if (!is_finite(corner)) throw InputError("view: eye and look-at are too far apart");
    for (std::size_t i = 0; i < 4; ++i)
        view.planes[i] = plane_through(view.eye, view.corners[i], view.corners[(i + 1) % 4], view.look_at);
    return view;
}

View<2> narrowed(const View<2>& view, const Vec<2>& right, const Vec<2>& left) {
    View<2> part = view;
    part.all_round = false;
    part.corners = {right, left};
    return part;
}

View<3> narrowed(const View<3>& view, const Box<2>& part) {
    View<3> narrow = view;
    const auto& c = view.corners;
    const Vec<3> right = (c[1] - c[0]) * 0.5, up = (c[3] - c[0]) * 0.5, middle = (c[0] + c[2]) * 0.5;
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = i == 1 || i == 2 ? part.max.x : part.min.x, y = i >= 2 ? part.max.y : part.min.y;
        narrow.corners[i] = middle + right * x + up * y;
    }
    const Vec<3> inner = (narrow.corners[0] + narrow.corners[2]) * 0.5;
    for (std::size_t i = 0; i < 4; ++i)
        narrow.planes[i] = plane_through(view.eye, narrow.corners[i], narrow.corners[(i + 1) % 4], inner);
    return narrow;
}

bool in_view(const View<2>& view, const Primitive<2>& segment) {
    if (view.all_round) return true;
    const auto& [a, b] = segment;
    const int right_a = side_of_right(view, a), left_a = side_of_left(view, a);
    if (right_a >= 0 && left_a >= 0) return true;
    const int right_b = side_of_right(view, b), left_b = side_of_left(view, b);
    if (right_b >= 0 && left_b >= 0) return true;
    // Both borders, because a segment may pass through the eye along one of them.
    return meets_ray(view, right_a, right_b, a, b) || meets_ray(view, -left_a, -left_b, a, b);
}

bool in_view(const View<2>& view, std::span<const Vec<2>> cell_corners) {
    // A bounded cell that meets the unbounded cone has a border that meets it too.
    for (std::size_t i = 0; i < cell_corners.size(); ++i)
        if (in_view(view, Primitive<2>{cell_corners[i], cell_corners[(i + 1) % cell_corners.size()]})) return true;
    return false;
}

bool in_view(const View<3>& view, std::span<const Vec<3>> cell_corners) {
    if (view.all_round) return true;
    for (const ViewPlane& plane : view.planes) {
        std::size_t outside = 0;
        while (outside < cell_corners.size() && beyond(plane, cell_corners[outside] - view.eye)) ++outside;
        if (outside == cell_corners.size()) return false;
    }
    return true;
}

unsigned planes_beyond(const View<3>& view, const Vec<3>& p) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < view.planes.size(); ++i)
        bits |= static_cast<unsigned>(beyond(view.planes[i], p - view.eye)) << i;
    return bits;
}

bool in_view(const View<3>& view, const Primitive<3>& triangle) {
    return in_view(view, std::span<const Vec<3>>(triangle));
}

bool all_in_view(const View<2>& view, std::span<const Vec<2>> cell_corners) {
    return view.all_round || std::all_of(cell_corners.begin(), cell_corners.end(), [&](const Vec<2>& p) {
               return side_of_right(view, p) >= 0 && side_of_left(view, p) >= 0;
           });
}

bool all_in_view(const View<3>& view, std::span<const Vec<3>> cell_corners) {
    if (view.all_round) return true;
    for (const ViewPlane& plane : view.planes)
        for (const Vec<3>& p : cell_corners) {
            const Vec<3> q = p - view.eye;
            if (!(glm::dot(plane.inward, q) > glm::dot(plane.uncertainty, glm::abs(q)) + smallest_product))
                return false;
        }
    return true;
}

}  // namespace sightline
