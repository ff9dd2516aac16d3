// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer3d/renderers.h"

#include <iostream>

#include "core/session/settings_table.h"
#include "shell/gl/draw_ids.h"

namespace sightline {

Renderers::Made& Renderers::made() {
    if (made_) return *made_;
    if (!has_current_context()) {
        off_screen_.reset();
        off_screen_.emplace(GlContext::Place::off_screen, "sightline", 64, 64);
    }
    return made_.emplace();
}

Graphics graphics_of(const std::shared_ptr<Renderers>& renderers) {
    Graphics graphics;
    graphics.draw_ids = draw_ids_with([renderers]() -> IdRenderer& { return renderers->ids(); },
                                      [](const std::string& line) { std::cerr << "warning: " << line << "\n"; });
    graphics.draw_solid = [renderers](const SolidList& list, int width, int height, double px_per_pt) {
        return renderers->solids().picture(list, width, height, px_per_pt);
    };
    graphics.time_drawing = [renderers](const ImageSize& asked) -> TimeDrawing {
        return [renderers, size = image_size<3>(asked)](const std::shared_ptr<const Scene<3>>& scene,
                                                        const View<3>& view, std::span<const std::uint32_t> triangles) {
            return renderers->clock().time(size, scene, view, triangles);
        };
    };
    return graphics;
}

}  // namespace sightline
