// The picture of the 2D viewer in the window: draw list, OpenGL, labels, mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/picture.h"
#include "shell/bench/workbench.h"
#include "shell/gl/list_renderer.h"
#include "shell/window/stage.h"
#include "viewer2d/picking.h"

namespace sightline {

class Picture2d {
public:
    /// An OpenGL context is current. The bench must live longer.
    explicit Picture2d(Workbench<2>& bench) : bench_(bench) {}

    void draw(Ui& ui, const Area& area);
    void interact(Ui& ui, const Area& area);
    bool cancel();

private:
    struct Drag {
        Handle handle = Handle::none;
        bool pans = false;
        ImVec2 from{};
        ViewSpec<2> view;
        Box<2> world;
    };

    void update(const Ui& ui, const Area& area);
    void draw_labels(const Ui& ui) const;
    void draw_hover(Ui& ui, const Pick& under);
    void mouse(Ui& ui, const Pick& under);
    void zoom_at(Ui& ui, const ImVec2& mouse, double factor);
    void drag_on(Ui& ui);
    void click(Ui& ui, const Pick& under);

    Workbench<2>& bench_;
    ListRenderer renderer_;
    DrawList list_;
    Camera camera_;
    std::uint64_t revision_ = 0;
    Area area_;
    std::optional<std::array<double, 2>> heat_range_;
    std::uint64_t heat_run_ = 0;
    CellNumber heat_ = CellNumber::none;
    std::optional<Drag> drag_;
    ImVec2 last_click_{-1, -1};
    int clicks_ = 0;  ///< at the same place: each takes the next thing that lies there
};

}  // namespace sightline
