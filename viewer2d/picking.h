// What lies under the mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "viewer2d/camera.h"

namespace sightline {

/// What a drag takes hold of.
enum class Handle : std::uint8_t { none, eye, look_at, segment_start, segment_end, segment, note };

struct Pick {
    Handle handle = Handle::none;
    std::uint32_t note = sightline::none;  ///< of Handle::note
    std::uint32_t primitive = sightline::none;
    std::uint32_t cell = sightline::none;
};

/// Window units within which a handle and a primitive are hit, at scale 1.
inline constexpr float handle_reach = 9, primitive_reach = 6;

/// Where the handle of the view's direction stands: a fixed distance from the eye on the screen.
ImVec2 look_handle(const ViewSpec<2>& view, const Camera& camera, float unit);

/// Everything under a point: a handle, the nearest primitive within reach, and the cell.
Pick pick(const Session<2>& session, const Camera& camera, const ImVec2& mouse, float unit);

}  // namespace sightline
