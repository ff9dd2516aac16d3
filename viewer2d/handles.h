// What a drag can take hold of, and where it stands in the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/session/session.h"
#include "viewer2d/camera.h"

namespace sightline {

enum class Handle : std::uint8_t {
    none,
    eye,      ///< of the display view, which is the culling view unless frozen
    look,     ///< turns it
    opening,  ///< an edge of its cone
    frozen_eye,
    frozen_look,
    frozen_opening,
    segment_start,
    segment_end,
    segment,
    note_text,    ///< moves the text, or a callout with its anchor
    note_anchor,  ///< what the selected note points at
};

struct HandlePoint {
    Handle handle = Handle::none;
    ImVec2 at{};
    std::uint32_t segment = sightline::none;  ///< whose end it is
};

/// Outside the edit mode only the eyes can be dragged, so that nothing is changed by accident.
struct EditMode {
    bool on = false;
    std::uint32_t hovered = sightline::none;  ///< the segment under the mouse
};

/// Window units within which a handle is hit, at scale 1.
inline constexpr float handle_reach = 9;

/// In the order in which they are hit where several are as near: the view's (those of the frozen culling view last, and
/// only where it differs), then the ends of the selected segment and of the one under the mouse. `unit` as Ui::unit.
std::vector<HandlePoint> handle_points(const Session<2>& session, const Camera& camera, float unit,
                                       const EditMode& edit);

/// The view after its handle was dragged from `from` to `to`; the view itself where that is none.
ViewSpec<2> dragged_view(const ViewSpec<2>& view, Handle handle, const Vec<2>& from, const Vec<2>& to);

/// The handle's name in Workbench::places, and what it does, for its tooltip.
const char* handle_name(Handle handle);
const char* handle_tip(Handle handle);

}  // namespace sightline
