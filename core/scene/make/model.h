// Inside core/scene: building 3D scenes out of triangles, most of them parts of closed solids. z is up. Uses only
// + - * / and sqrt, so that scenes are the same bits on every machine.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <initializer_list>
#include <span>
#include <vector>

#include "core/base/float_value.h"
#include "core/scene/make/catalogue.h"
#include "core/scene/make/sketch.h"

namespace sightline {

/// Sides of a box, as bits; the front is the one at the smallest y.
enum BoxSides : unsigned {
    left_side = 1,
    right_side = 2,
    front_side = 4,
    back_side = 8,
    bottom_side = 16,
    top_side = 32,
    all_sides = 63,
};

/// To 1/1024 m: a few such numbers added up are floats still, so that what is in line or in one plane stays there.
inline double dyadic(double x) { return std::floor(x * 1024 + 0.5) / 1024; }
inline Vec<2> dyadic(const Vec<2>& p) { return {dyadic(p.x), dyadic(p.y)}; }

/// Triangles so far and the frame in which the next ones are given: turned about z, then moved. Fronts look out of the
/// solids. Corners are rounded to float.
struct Model {
    std::vector<Primitive<3>> triangles;
    Placement plan;
    double height = 0;  ///< z of the frame's origin
    /// How many triangles are wanted. Scenes are added to in pieces of at most 500; full() says when to stop, so that
    /// the last piece is as likely to be above as below.
    std::size_t wanted = most_triangles;

    bool full() const { return triangles.size() + 240 >= wanted; }
    Vec<3> at(const Vec<3>& p) const {
        const Vec<2> q = plan.at({p.x, p.y});
        return Vec<3>(float_value(q.x), float_value(q.y), float_value(p.z + height)) + 0.0;  // no -0
    }
    /// Corners counter-clockwise as seen from the front.
    void triangle(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) { triangles.push_back({at(a), at(b), at(c)}); }
    /// A convex polygon, corners counter-clockwise as seen from the front.
    void polygon(std::span<const Vec<3>> corners);
    void polygon(std::initializer_list<Vec<3>> corners) { polygon(std::span(corners.begin(), corners.size())); }
    void box(const Vec<3>& low, const Vec<3>& high, unsigned sides = all_sides);
    /// A solid of revolution: profile points are (radius, distance along the axis), from the foot on. Where the radius
    /// is 0 the solid closes. `axis` has length 1.
    void turned_solid(const Vec<3>& foot, const Vec<3>& axis, std::span<const Vec<2>> profile, int corners);
    void turned_solid(const Vec<3>& foot, const Vec<3>& axis, std::initializer_list<Vec<2>> profile, int corners) {
        turned_solid(foot, axis, std::span(profile.begin(), profile.size()), corners);
    }
    /// A rod with closed ends between two points.
    void rod(const Vec<3>& a, const Vec<3>& b, double radius, int corners);
    /// A rod with open ends that begins at a toward the corner and bends to c, as a quadratic Bezier curve. The three
    /// points are not in line.
    void bent_rod(const Vec<3>& a, const Vec<3>& corner, const Vec<3>& c, double radius, int pieces, int corners);
};

/// A frame inside the model's own until the end of the scope.
class Inside {
public:
    Inside(Model& model, const Vec<3>& origin, double degrees = 0);
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside();

private:
    Model& model_;
    Placement outer_plan_;
    double outer_height_;
};

}  // namespace sightline
