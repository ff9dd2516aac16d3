// What lies under the mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "viewer2d/handles.h"

namespace sightline {

struct Pick {
    Handle handle = Handle::none;
    std::uint32_t primitive = sightline::none;  ///< the nearest within reach
    std::uint32_t cell = sightline::none;
};

/// Window units within which a primitive is hit and ends snap, at scale 1.
inline constexpr float primitive_reach = 6;

/// The nearest of the points within handle_reach, the first of those as near. The selected segment's own line is a
/// handle too, after the points.
Pick pick(const Session<2>& session, const Camera& camera, std::span<const HandlePoint> handles, const ImVec2& mouse,
          float unit);

/// `at`, or the nearest end of a segment within reach of it. `but`: a segment that does not count; none: all do.
Vec<2> snapped_to_end(const Session<2>& session, const Camera& camera, const Vec<2>& at, float unit,
                      std::uint32_t but = none);

/// The cell whose centre is the nearest within reach of the point; none when there is none.
std::uint32_t centre_near(const Session<2>& session, const Camera& camera, const Vec<2>& at, float unit);

/// Repeated clicks at one place go through what lies there: the primitive, the cell, and so on.
class ClickCycle {
public:
    /// What this click takes: "primitive:N", "N" or "none".
    std::string next(const Pick& under, const ImVec2& at, float reach);
    /// A click at the same place begins anew.
    void forget() { last_ = {-1e9f, -1e9f}; }

private:
    ImVec2 last_{-1e9f, -1e9f};
    std::size_t clicks_ = 0;
};

}  // namespace sightline
