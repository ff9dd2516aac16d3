// The picture of the 2D viewer in the window: one pane, or two for a comparison, and the mouse on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "shell/desk/workbench.h"
#include "shell/pane/side_by_side.h"
#include "shell/window/stage.h"
#include "viewer2d/mouse2d.h"
#include "viewer2d/pane2d.h"

namespace sightline {

class Picture2d {
public:
    /// An OpenGL context is current. The bench must live longer.
    explicit Picture2d(Workbench<2>& bench) : bench_(bench), sessions_(bench), mouse_(bench) {}

    /// As Stage has them; interact comes first in a frame and brings the picture up to date.
    void interact(Ui& ui, const Area& area);
    void draw(Ui& ui, const Area& area);
    bool cancel() { return mouse_.cancel(); }
    /// Whether it moves by itself.
    bool lively() const { return panes_[0].fading() || panes_[1].fading(); }

    /// The left or only pane's, as of the last frame.
    const Camera& camera() const { return panes_[0].camera(); }
    std::size_t label_count() const { return panes_[0].spots().size(); }

private:
    std::vector<MousePane> mouse_panes(const Area& area);
    void update(const Ui& ui, const Area& area);
    void draw_over(Ui& ui, const std::vector<MousePane>& panes, const Area& area);
    void draw_head(const Ui& ui, const Area& area, std::size_t side);
    void outline(const Ui& ui, const MousePane& pane, std::uint32_t cell) const;
    void note_cells();
    /// Below the head of a comparison.
    float badge_down() const { return bench_.other ? 2 * ImGui::GetFontSize() : 0; }

    Workbench<2>& bench_;
    SideBySide<2> sessions_;
    Mouse2d mouse_;
    std::array<Pane2d, 2> panes_;
    std::array<std::string, 2> heads_;  ///< over the panes of a comparison
};

}  // namespace sightline
