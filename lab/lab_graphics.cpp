// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/lab_graphics.h"

#include <iostream>

#include "core/base/error.h"
#include "core/session/settings_table.h"
#include "shell/gl/context.h"
#include "shell/gl/draw_clock.h"
#include "shell/gl/draw_ids.h"
#include "shell/gl/id_renderer.h"
#include "shell/gl/solid_renderer.h"

namespace sightline::lab {

struct LabGraphics::Made {
    GlContext context{GlContext::Place::off_screen, "sightline lab", 64, 64};
    IdRenderer ids;
    SolidRenderer solids;
    DrawClock clock;
};

LabGraphics::LabGraphics() = default;
LabGraphics::~LabGraphics() = default;

LabGraphics::Made& LabGraphics::made() {
    if (!made_) made_ = std::make_unique<Made>();
    return *made_;
}

DrawIds LabGraphics::draw_ids() {
    return draw_ids_with([this]() -> IdRenderer& { return made().ids; },
                         [](const std::string& line) { std::cerr << "lab: warning: " << line << "\n"; });
}

DrawSolid LabGraphics::draw_solid() {
    return [this](const SolidList& list, int width, int height, double px_per_pt) {
        return made().solids.picture(list, width, height, px_per_pt);
    };
}

TimeDrawing LabGraphics::time_drawing(const ImageSize& asked) {
    return [this, size = image_size<3>(asked)](const std::shared_ptr<const Scene<3>>& scene, const View<3>& view,
                                               std::span<const std::uint32_t> triangles) {
        return made().clock.time(size, scene, view, triangles);
    };
}

bool LabGraphics::has_opengl() {
    try {
        made();
        return true;
    } catch (const WorkError&) {
        return false;
    }
}

std::string LabGraphics::description() { return has_opengl() ? made().context.description() : "no OpenGL"; }

}  // namespace sightline::lab
