// The culling view: the eye and the cone it sees. One definition for methods and references alike.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/geometry/predicates.h"
#include "core/scene/scene.h"

namespace sightline {

/// A plane through the eye that bounds a 3D view cone. For a point q relative to the eye, dot(inward, q) is the side it
/// lies on, positive inside; the rounding error is below dot(uncertainty, |q|).
struct ViewPlane {
    Vec<3> inward{}, uncertainty{};
};

/// Eye and view cone. The cone is fixed by points, not angles, so that every test on it is exact: it is the set of
/// points between the rays from the eye through corners[i]. 2D: corners are {right, left} as seen from the eye; 3D:
/// four, counter-clockwise as seen from the eye. all_round: there is no cone, everything is in view.
template <int D>
struct View {
    Vec<D> eye{};
    Vec<D> look_at{};
    double fov = 60;  ///< degrees; kept for display, decisions use the corners
    bool all_round = false;
    std::array<Vec<D>, 2 * (D - 1)> corners{};
    /// 3D: through corners i and i + 1.
    std::array<ViewPlane, D == 3 ? 4 : 0> planes{};

    /// Unit vector from the eye to look_at.
    Vec<D> forward() const { return (look_at - eye) / std::sqrt(glm::dot(look_at - eye, look_at - eye)); }
};

/// The part of the view between the rays through two points, `left` being less than half a turn counter-clockwise of
/// `right`.
View<2> narrowed(const View<2>& view, const Vec<2>& right, const Vec<2>& left);
/// The part of the image, which goes from -1 (left, bottom) to +1; rounded.
View<3> narrowed(const View<3>& view, const Box<2>& part);

/// What points up in a view along the axis that usually does.
constexpr int other_axis(int up_axis) { return up_axis == 0 ? 2 : 3 - up_axis; }

/// Builds the view. Throws InputError when a coordinate is not finite, when look_at coincides with the eye, when they
/// are so far apart that the corners overflow (3D: 1e150 or more), or when fov is outside (0, 180); fov = 360 looks all
/// round (2D only).
View<2> make_view(const ViewSpec<2>& spec);
/// As above; `aspect` is width / height of the image; up_axis points up unless the view looks along it:
/// then other_axis() does.
View<3> make_view(const ViewSpec<3>& spec, double aspect, int up_axis = 2);

/// Whether the triangle turns its front to the eye: the side from which its corners turn counter-clockwise. Exact; one
/// that is seen edge-on does not. Methods and references alike leave out triangles that do not, unless they are
/// two-sided.
inline bool faces(const View<3>& view, const Primitive<3>& triangle) {
    return orient(triangle[0], triangle[1], triangle[2], view.eye) > 0;
}

/// Whether the closed primitive meets the closed cone. 2D: exact. 3D: conservative (never false when it does): true
/// also for one that lies beyond no single plane of the cone.
bool in_view(const View<2>& view, const Primitive<2>& segment);
bool in_view(const View<3>& view, const Primitive<3>& triangle);

/// Bit i: the point lies beyond plane i of the cone, for sure. in_view() is true of what has no bit that all of its
/// corners have.
unsigned planes_beyond(const View<3>& view, const Vec<3>& p);

/// The same for a convex cell: 2D, its corners in order around it; 3D, its corners in any order.
bool in_view(const View<2>& view, std::span<const Vec<2>> cell_corners);
bool in_view(const View<3>& view, std::span<const Vec<3>> cell_corners);

/// Whether all of the convex cell lies in the cone; never true when a part of it does not.
bool all_in_view(const View<2>& view, std::span<const Vec<2>> cell_corners);
bool all_in_view(const View<3>& view, std::span<const Vec<3>> cell_corners);

}  // namespace sightline
