// Where scene points lie in the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/vec.h"
#include "shell/window/ui.h"

namespace sightline {

/// Maps the world box of a picture onto an area of the same aspect; y up in the scene, down in the window.
struct Camera {
    Box<2> world;
    Area area;

    double scale() const { return area.w / world.extent().x; }  ///< window units per scene unit
    ImVec2 to_window(const Vec<2>& p) const {
        return {static_cast<float>(area.x + (p.x - world.min.x) * scale()),
                static_cast<float>(area.y + area.h - (p.y - world.min.y) * scale())};
    }
    Vec<2> to_scene(const ImVec2& p) const {
        return {world.min.x + (p.x - area.x) / scale(), world.min.y + (area.y + area.h - p.y) / scale()};
    }
};

}  // namespace sightline
