// What lies under the mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viewer2d/handles.h"

namespace sightline {

struct Pick {
    Handle handle = Handle::none;
    std::uint32_t primitive = sightline::none;  ///< the nearest within reach
    std::uint32_t cell = sightline::none;
    std::uint32_t node = sightline::none;     ///< of a method that walks boxes, in the place of a cell
    std::uint32_t segment = sightline::none;  ///< what the handle is of
};

/// Window units within which a primitive is hit and ends snap, at scale 1.
inline constexpr float primitive_reach = 6;

/// The nearest within reach; none when there is none.
std::uint32_t segment_near(const Session<2>& session, const Camera& camera, const ImVec2& mouse, float unit);

/// The nearest of the points within handle_reach, the first of those as near. In the edit mode the line of a segment is
/// a handle too, after the points.
Pick pick(const Session<2>& session, const Camera& camera, std::span<const HandlePoint> handles, const ImVec2& mouse,
          float unit, bool edit);

/// `at`, or the nearest end of a segment within reach of it. `but`: a segment that does not count; none: all do.
Vec<2> snapped_to_end(const Session<2>& session, const Camera& camera, const Vec<2>& at, float unit,
                      std::uint32_t but = none);

/// The cell whose centre is the nearest within reach of the point; none when there is none.
std::uint32_t centre_near(const Session<2>& session, const Camera& camera, const Vec<2>& at, float unit);

/// What a click can take, as `select` takes it: the primitive, then the cell or the box.
std::vector<std::string> choices(const Pick& under);

}  // namespace sightline
