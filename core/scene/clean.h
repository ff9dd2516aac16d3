// From the raw primitives of a file to a scene that everything else may rely on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace sightline {

/// The largest coordinate that a scene may have: products of differences must not overflow. The longest side of a
/// scene must not be below 1 / largest_coordinate, so that squares do not underflow to zero.
inline constexpr double largest_coordinate = 1e150;

enum class Recentre { no, yes };

/// The shift of an axis: 0 while the centre is within 4 longest sides of zero, else a number near it with few bits (a
/// multiple of the power of two just below the longest side), so that origins are short to print.
double origin_for(double centre, double longest_side);

/// Drops, in this order and in place, segments that are not finite, of zero length or repeat an earlier one in either
/// direction, and adds to scene.dropped. The others keep their order, and scene.objects is kept in step and tidied.
/// Recentre::yes then moves each axis by its origin_for() and adds that to scene.origin and subtracts it from the start
/// view. By Sterbenz's lemma the subtraction is exact: origin + coordinate is the file's number, bit for bit.
/// Warns when nothing is left. Throws InputError, which begins with `name`, when a coordinate is beyond
/// largest_coordinate or the scene is too small.
void clean(Scene<2>& scene, Recentre recentre, const std::string& name);

/// As largest_coordinate, for triangles: graphics cards square floats.
inline constexpr double largest_triangle_coordinate = 1e18;

/// The same for triangles. Recentring comes first, over all that is finite, and then each coordinate is rounded to
/// float (no -0), so what is tested is what is drawn and measured. Dropped are triangles that are not finite, have
/// exactly no area or have the corners of an earlier one in the same cyclic order; one that turns the other way stays.
/// scene.objects (tidied) and scene.two_sided are kept in step (the latter empty when none is); of two equal triangles the one that stays is two-sided when
/// either is. Extra memory: at most 16 bytes a triangle. Limits as above, at largest_triangle_coordinate.
void clean(Scene<3>& scene, Recentre recentre, const std::string& name, const Progress& progress = {});

/// A view for scenes that come without one. The box, grown by one cell on every side, is cut into cells of 1/32 of its
/// longest side; the eye stands in the centre of the cell that no segment crosses and that is farthest from crossed
/// cells and from the grid's rim (ties: nearest the box's centre, then the lowest index), or below the box when every
/// cell is crossed. It looks at the midpoint of the segment whose midpoint is nearest the box's centre, so something is
/// always in view. fov is 90. A scene with no segments is looked at from (0, 0) toward (1, 0).
ViewSpec<2> default_view(const std::vector<Primitive<2>>& segments);

/// A view for triangles that come without one, found by casting some ten thousand rays; `two_sided` as in Scene. Tried
/// are
///  - the camera, if given; it is taken when it sees the front of a triangle;
///  - outside: from 8 directions and 5 heights toward the centre, the box whole in a picture of 4:3. Taken for objects:
///    scenes that show their fronts to the outside and leave a tenth of their footprint empty, or are solids: fronts to
///    all sides, from below too, and no floors with a roof in more than two thirds of the footprint;
///  - inside: eyes at half the usual room height (a hundredth of the longest side where there are no rooms) above up to
///    64 surfaces that face up and have that much air, found by 12 x 12 vertical rays, in 32 directions each, level;
///    not where more than a fifth of the rays that go down leave the scene.
/// The best shows many different triangles at many depths (powers of two of the distance), few backs and little that is
/// nearer than the ground. When nothing shows anything the eye is before the largest triangle. fov is that of the
/// camera, or 60; look_at is at the middle distance of what is seen. Large scenes are judged by their million largest
/// triangles. No triangles: from zero along x.
ViewSpec<3> default_view(const std::vector<Primitive<3>>& triangles, int up_axis,
                         const std::vector<std::uint8_t>& two_sided = {},
                         const std::optional<ViewSpec<3>>& camera = {});

/// Throws InputError "name: place: reason" unless the view is finite, looks somewhere and has a usable field of view:
/// (0, 180) degrees, or 360 in 2D.
template <int D>
void check_view(const ViewSpec<D>& view, const std::string& name, const std::string& place);

}  // namespace sightline
