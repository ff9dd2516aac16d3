// The OpenGL that the 3D viewer shares between its pictures, references and exports.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "shell/desk/graphics.h"
#include "shell/gl/context.h"
#include "shell/gl/draw_clock.h"
#include "shell/gl/id_renderer.h"
#include "shell/gl/solid_renderer.h"

namespace sightline {

/// Made on first use: with the window's context where one is current, else with one of its own off screen.
class Renderers {
public:
    IdRenderer& ids() { return made().ids; }
    SolidRenderer& solids() { return made().solids; }
    DrawClock& clock() { return made().clock; }
    /// Before the context that is current goes away; the next use makes them again.
    void drop() { made_.reset(); }

private:
    struct Made {
        IdRenderer ids;
        SolidRenderer solids;
        DrawClock clock;
    };
    Made& made();

    std::optional<GlContext> off_screen_;
    std::optional<Made> made_;
};

/// What the bench is handed; the functions keep the renderers alive.
Graphics graphics_of(const std::shared_ptr<Renderers>& renderers);

}  // namespace sightline
