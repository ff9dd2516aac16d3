// The picture of the 2D viewer in the window: one pane, or two for a comparison, and the mouse on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "shell/desk/workbench.h"
#include "shell/window/stage.h"
#include "viewer2d/mouse2d.h"
#include "viewer2d/pane2d.h"

namespace sightline {

class Picture2d {
public:
    /// An OpenGL context is current. The bench must live longer.
    explicit Picture2d(Workbench<2>& bench) : bench_(bench), mouse_(bench) {}

    /// As Stage has them; interact comes first in a frame and brings the picture up to date.
    void interact(Ui& ui, const Area& area);
    void draw(Ui& ui, const Area& area);
    bool cancel() { return mouse_.cancel(); }

    /// The left or only pane's, as of the last frame.
    const Camera& camera() const { return panes_[0].camera(); }
    std::size_t label_count() const { return panes_[0].spots().size(); }

private:
    /// The heat map's range, which stays while one steps.
    struct HeatRange {
        std::uint64_t run = 0;
        CellNumber what = CellNumber::none;
        const Session<2>* of = nullptr;
        std::optional<std::array<double, 2>> range;
    };

    const Session<2>& session_of(std::size_t pane) const;
    std::size_t pane_count() const { return bench_.other ? 2 : 1; }
    std::vector<MousePane> mouse_panes(const Area& area);
    void update(const Ui& ui, const Area& area);
    void draw_over(Ui& ui, const std::vector<MousePane>& panes, const Area& area);
    void outline(const Ui& ui, const MousePane& pane, std::uint32_t cell) const;
    void note_cells();

    Workbench<2>& bench_;
    Mouse2d mouse_;
    std::array<Pane2d, 2> panes_;
    std::array<HeatRange, 2> heat_;
    std::vector<Side> sides_;  ///< who projected what; empty without a second session of the same cells
    std::uint64_t sides_revision_ = 0;
};

}  // namespace sightline
