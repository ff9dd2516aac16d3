// A drag over the picture: what the bench becomes while the mouse moves.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/gesture.h"
#include "viewer2d/picking.h"

namespace sightline {

/// What a drag does.
enum class DragKind : std::uint8_t { pan, handle, draw_segment, cut_gap };

/// As things were when the button went down.
struct Drag {
    DragKind kind = DragKind::pan;
    Handle handle = Handle::none;
    std::uint32_t note = none;  ///< of the note's handles
    Vec<2> from{};              ///< scene point under the mouse
    Camera camera;              ///< its world stays while a handle is dragged, or the picture would slip away
    Gesture<2> before;
    std::uint32_t segment = none;  ///< whose handle it is, or that is cut
};

/// Makes the bench what the drag makes of it when the mouse is at this window point; every call starts from what was
/// before, all make one entry of the history. Places that cannot be (a segment without length) change nothing.
void drag_to(Workbench<2>& bench, const Drag& drag, const ImVec2& mouse, float unit);

/// The point that an end would snap to, for a mark; nothing when it would not.
std::optional<Vec<2>> snap_point(const Workbench<2>& bench, const Drag& drag, const ImVec2& mouse, float unit);

}  // namespace sightline
