// The picture of the 3D viewer in the window: one pane, or two for a comparison, the mouse and the keys on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "shell/desk/workbench.h"
#include "shell/pane/side_by_side.h"
#include "shell/window/stage.h"
#include "viewer3d/counters.h"
#include "viewer3d/eye_pictures.h"
#include "viewer3d/mouse3d.h"
#include "viewer3d/pane3d.h"

namespace sightline {

class Picture3d {
public:
    /// An OpenGL context is current. The bench must live longer.
    explicit Picture3d(Workbench<3>& bench) : bench_(bench), sessions_(bench), mouse_(bench) {}

    /// As Stage has them; interact comes first in a frame and brings the picture up to date.
    void interact(Ui& ui, const Area& area);
    void draw(Ui& ui, const Area& area);
    bool cancel() { return mouse_.cancel(); }
    bool takes_key(const std::string& key) const;
    bool lively() const {
        return bench_.flight.on || bench_.flight.replaying || panes_[0].fading() || panes_[1].fading();
    }

    const Pane3d& pane() const { return panes_[0]; }

private:
    /// What belongs to one session, from above: its counters, the picture and, where it is split, the culling eye's.
    struct Part {
        Area whole, head, picture;
        std::optional<Area> split;  ///< as large as the picture
        std::vector<Counter> counters;
    };

    std::string title_of(std::size_t pane) const;
    void fly(Ui& ui, float seconds);
    void measure(Ui& ui);
    Part lay_out(const Ui& ui, const Area& area, std::size_t pane) const;
    void update(const Ui& ui);
    std::optional<std::array<int, 2>> pixel_under_mouse(const Ui& ui) const;
    void draw_part(ImDrawList& list, const Ui& ui, std::size_t pane);
    void note(const std::string& name, const Area& area);
    void note_cells();

    Workbench<3>& bench_;
    SideBySide<3> sessions_;
    Mouse3d mouse_;
    std::array<Pane3d, 2> panes_;
    std::array<Part, 2> parts_;
    std::array<EyePictures, 2> eyes_;
    std::array<DrawnFrames, 2> drawn_frames_;  ///< of flights
    std::uint64_t drawn_run_ = 0;
    std::uint64_t flown_ = 0;  ///< the run of the last frame
    float unmeasured_ = 0;     ///< seconds since the last exact image
    float rested_ = 0;         ///< seconds since the eye last flew
    double measure_ms_ = 0;    ///< what the last exact image took, of both sessions
};

}  // namespace sightline
