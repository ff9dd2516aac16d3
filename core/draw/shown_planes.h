// The box, the occluder and the planes between them that a picture shows, of a method that decides by planes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/session/session.h"

namespace sightline {

/// The box that pictures and panels speak of: the selected one, else the smallest one around the selected primitive
/// where that is no occluder, else what the last step popped. None where the method walks no boxes.
template <int D>
std::uint32_t box_at_hand(const Session<D>& session);

/// That box, where it is not only what the last step popped.
template <int D>
std::optional<Box<D>> explained_box(const Session<D>& session);

/// Whether the primitive is of an occluder; `actual`: of one that hides something.
template <int D>
bool is_of_occluder(const Session<D>& session, std::uint32_t primitive, bool actual);

/// What a 3D picture marks as occluders: those of a method that decides by planes, and the candidates of one that
/// chooses by viewpoint, where its picture shows them.
std::vector<OccluderFact> marked_occluders(const Session<3>& session);
/// Whether there may be some.
bool marks_occluders(const Session<3>& session);

/// The selected primitive, where it is of an actual occluder; none: of the occluders the one that hides most.
template <int D>
std::uint32_t occluder_at_hand(const Session<D>& session);

/// Planes between the two; empty where the box was not tested so far.
template <int D>
std::vector<TestedPlane<D>> planes_at_hand(const Session<D>& session);

/// From where the selected primitive is of an occluder.
template <int D>
std::optional<OccluderRegion<D>> region_at_hand(const Session<D>& session);

/// Of figure 4a in 2D: where eyes lie from which the occluder hides a part of the box (2) or all of it (3), cut to a
/// world; each is convex. Of 1 and 2 also the two parts, for their numbers. Empty where the planes do not make one: the
/// box does not lie beyond the occluder, or its silhouette turns with the eye.
struct EyeRegions {
    std::vector<Vec<2>> partial, hidden;
    std::vector<std::vector<Vec<2>>> parts_1, parts_2;
};
EyeRegions eye_regions(const std::vector<TestedPlane<2>>& planes, const Vec<2>& eye, const Box<2>& world);

/// The middle of a convex polygon, and its area.
struct Middle {
    Vec<2> at{};
    double area = 0;
};
Middle middle_of(const std::vector<Vec<2>>& polygon);

/// A piece of a plane for a picture: a parallelogram on its edge, through its corner and somewhat beyond, and back to
/// beside the eye.
std::array<Vec<3>, 4> piece_of(const TestedPlane<3>& plane, const Vec<3>& eye);

}  // namespace sightline
