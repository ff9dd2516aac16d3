// The picture of the 3D viewer in the window: one pane, or two for a comparison, the mouse and the keys on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "shell/bench/workbench.h"
#include "shell/window/stage.h"
#include "viewer3d/inset_picture.h"
#include "viewer3d/mouse3d.h"
#include "viewer3d/pane3d.h"

namespace sightline {

class Picture3d {
public:
    /// An OpenGL context is current. The bench must live longer.
    explicit Picture3d(Workbench<3>& bench) : bench_(bench), mouse_(bench) {}

    /// As Stage has them; interact comes first in a frame and brings the picture up to date.
    void interact(Ui& ui, const Area& area);
    void draw(Ui& ui, const Area& area);
    bool cancel() { return mouse_.cancel(); }
    bool takes_key(const std::string& key) const;
    bool lively() const { return bench_.flight.on || bench_.flight.replaying; }

    const Pane3d& pane() const { return panes_[0]; }

private:
    struct HeatRange {
        std::uint64_t run = 0;
        CellNumber what = CellNumber::none;
        std::optional<std::array<double, 2>> range;
    };

    const Session<3>& session_of(std::size_t pane) const;
    std::size_t pane_count() const { return bench_.other ? 2 : 1; }
    void fly(Ui& ui, float seconds);
    void update(const Ui& ui, const Area& area);
    void draw_counters(const Ui& ui, const Area& area, const Session<3>& session);
    void note_places();

    Workbench<3>& bench_;
    Mouse3d mouse_;
    std::array<Pane3d, 2> panes_;
    std::array<InsetPicture, 2> insets_;
    std::array<HeatRange, 2> heat_;
    std::vector<Side> sides_;
    std::uint64_t sides_revision_ = 0;
    float rested_ = 0;  ///< seconds since the eye last flew
};

}  // namespace sightline
