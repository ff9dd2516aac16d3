// The mouse on the 3D picture: circle, turn, move, come nearer, pick, and the handles of the frozen eye.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "shell/desk/gesture.h"
#include "shell/pane/click_cycle.h"
#include "shell/pane/note_field.h"
#include "viewer3d/pane3d.h"
#include "core/draw/picking_3d.h"

namespace sightline {

class Mouse3d {
public:
    /// The bench must live longer.
    explicit Mouse3d(Workbench<3>& bench) : bench_(bench) {}

    /// After the ImGui item that covers all panes, which are as the person sees them. `pixel`: of the exact image,
    /// under the mouse.
    void frame(Ui& ui, std::span<const Pane3d> panes, const std::optional<std::array<int, 2>>& pixel);
    /// Handles, tooltips, the note's field.
    void draw(Ui& ui, std::span<const Pane3d> panes, const Area& area);
    /// Ends a drag without effect, or drops a note that is being written; false when there is neither.
    bool cancel();
    /// The mouse is on something that lies over the picture.
    void leave() { hovered_ = false; }
    bool dragging() const { return drag_ != Drag::none; }

private:
    enum class Drag { none, orbit, turn, pan, frozen_eye, frozen_look };
    void press(Ui& ui, const Pane3d& pane);
    void drag(Ui& ui, const Pane3d& pane);
    std::uint32_t box_under(const Pane3d& pane, const ImVec2& at) const;
    void click(Ui& ui, const Pane3d& pane);
    void move_view(Ui& ui, const ViewSpec<3>& view);
    std::optional<ImVec2> handle_at(const Pane3d& pane, Drag handle) const;
    std::uint32_t wire_under(const Pane3d& pane, const ImVec2& at) const;
    void tooltip(Ui& ui, const Pane3d& pane);
    std::string pixel_words() const;

    Workbench<3>& bench_;
    NoteField field_;
    Drag drag_ = Drag::none;
    std::optional<Gesture<3>> before_;
    ViewSpec<3> from_{};  ///< the view that is dragged, as the button went down
    ImVec2 pressed_{};
    ClickCycle cycle_;
    bool hovered_ = false;
    std::optional<std::array<int, 2>> pixel_;  ///< under the mouse; one that is pressed on moves no view
    bool on_pixel_ = false;                    ///< the button went down on one
};

}  // namespace sightline
