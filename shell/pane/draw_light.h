// The term of a key that is under the mouse, lit in a pane's picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shell/window/ui.h"

namespace sightline {

/// Points of a line in the window; nothing where a point cannot be shown.
using WindowLine = std::vector<std::optional<ImVec2>>;

/// With a light rim, in the colour that the term has in words.
void draw_light(ImDrawList& list, const Ui& ui, KeyAbout about, const WindowLine& line, bool closed, bool arrow);

/// `to_window` maps a point of the scene to an optional place.
template <int D, typename ToWindow>
void draw_key_light(ImDrawList& list, const Ui& ui, const Session<D>& session, const KeyLight& light,
                    const ToWindow& to_window) {
    for (const LightLine<D>& shown : key_light(session, light)) {
        WindowLine line;
        for (const Vec<D>& point : shown.points) line.push_back(to_window(point));
        draw_light(list, ui, light.about, line, shown.closed, shown.arrow);
    }
}

}  // namespace sightline
