// The shadow of an occluder for one eye, and how a box lies to it: regions 1, 2 and 3 of CT figure 4.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/geometry/predicates.h"
#include "core/space/polygons.h"

namespace sightline {

/// A plane (2D: a line). For q = p - eye, dot(inward, q) - offset is the side on which p lies; the error of rounding is
/// below dot(uncertainty, |q|) + offset_uncertainty.
template <int D>
struct ShadowPlane {
    Vec<D> inward{}, uncertainty{};
    double offset = 0, offset_uncertainty = 0;
};

/// The plane through the eye and an edge of the occluder (2D: an end point). Inside: where the occluder is.
template <int D>
struct ShadowSide {
    ShadowPlane<D> plane;
    std::uint32_t polygon = none, side = none;  ///< which side of which polygon it is (Polygons::sides)
    std::uint32_t edge = none;
    bool reversed = false;  ///< runs against the direction of the edge, or (2D) is the left end, as the eye sees it
    Vec<D> a{}, b{};        ///< counter-clockwise as the eye sees it; 2D: a alone
    double length = 1;      ///< 3D: of the edge
};

/// The plane of one of the occluder's primitives. Inside: beyond it, as the eye sees it.
template <int D>
struct ShadowFront {
    ShadowPlane<D> plane;
    std::uint32_t primitive = none;
    bool from_behind = false;
};

/// One occluder: a polygon, or several that meet at edges and turn the same side to the eye. Sides are the silhouette.
template <int D>
struct Shadow {
    std::vector<std::uint32_t> polygons;  ///< ascending
    std::vector<ShadowSide<D>> sides;
    std::vector<ShadowFront<D>> fronts;
    double area_angle = 0;  ///< absolute
};

/// Which side of the polygon the eye sees: +1 the front, -1 the back of one that has two sides, 0: it hides nothing,
/// because it is seen from behind, edge-on, or not all of it from one side. Exact.
template <int D>
int side_seen(const Scene<D>& scene, const Polygons<D>& polygons, std::uint32_t polygon, const Vec<D>& eye);

/// The shadow of polygons of which the eye sees a side. Edges at which two of them lie on opposite sides, as the eye
/// sees it, are inner ones and no silhouette (CT figures 4b and 4c). Leaves `area_angle` alone.
template <int D>
void make_shadow(const Scene<D>& scene, const Polygons<D>& polygons, std::span<const std::uint32_t> of,
                 const Vec<D>& eye, Shadow<D>& shadow);

/// A box as an eye sees it.
template <int D>
struct EyeBox {
    const Box<D>& box;
    const Vec<D>& eye;
    Vec<D> low, high, reach;  ///< corners relative to the eye; the larger absolute value of both
    Vec<D> centre;
    double half_diagonal = 0;

    EyeBox(const Box<D>& of, const Vec<D>& from);
};

/// A convex polygon as an eye sees it.
template <int D>
struct EyePolygon {
    std::span<const Vec<D>> corners;
    const Vec<D>& eye;
    Vec<D> centre;             ///< of the corners' box
    double half_diagonal = 0;  ///< of that

    EyePolygon(std::span<const Vec<D>> of, const Vec<D>& from);
};

template <int D>
std::array<Vec<D>, 1 << D> corners_of(const EyeBox<D>& box) {
    return box.box.corners();
}
template <int D>
std::span<const Vec<D>> corners_of(const EyePolygon<D>& polygon) {
    return polygon.corners;
}

enum class Region : std::uint8_t {
    visible = 1,  ///< the occluder hides nothing of the box
    partial = 2,  ///< it may hide a part: all separating planes are satisfied
    hidden = 3,   ///< it hides all of it: all supporting planes are satisfied
};

/// How a box lies to a shadow. The supporting plane through an edge and the box is satisfied when all corners of the
/// box lie inside the plane through the edge and the eye, the separating one when some corner does: the planes turn
/// about the same edge, so that one look at each corner says both.
struct Relation {
    Region region = Region::visible;
    bool beyond = false;  ///< all of the box lies strictly beyond all of the occluder's planes
    /// How far the eye can move before any plane that decided can say something else, at least.
    double slack = 0;
};

/// Exact. Adds to `products` the planes it looked at.
template <int D>
Relation relation(const Shadow<D>& shadow, const Scene<D>& scene, const EyeBox<D>& box, std::uint64_t& products);
template <int D>
Relation relation(const Shadow<D>& shadow, const Scene<D>& scene, const EyePolygon<D>& polygon,
                  std::uint64_t& products);

/// The supporting plane of a side: whether it is satisfied, and how far the eye can move before that can change. Exact.
template <int D, typename Occludee>
std::pair<bool, double> supporting_plane(const ShadowSide<D>& side, const Occludee& occludee);

/// On which side of a plane the least and the most inner corner of the box lie: 1 inside, 0 on it, -1 outside.
/// Exact.
struct CornerSides {
    int low, high;
};
template <int D>
CornerSides corner_sides(const ShadowSide<D>& side, const EyeBox<D>& box);
template <int D>
CornerSides corner_sides(const ShadowFront<D>& front, const Scene<D>& scene, const EyeBox<D>& box);

}  // namespace sightline
