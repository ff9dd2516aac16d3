// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pane/draw_light.h"

#include <cmath>

#include "shell/window/formula.h"
#include "shell/window/theme.h"

namespace sightline {

void draw_light(ImDrawList& list, const Ui& ui, KeyAbout about, const WindowLine& line, bool closed, bool arrow) {
    const std::size_t count = line.size(), pieces = closed ? count : count - 1;
    for (const bool rim : {true, false}) {
        const ImU32 ink = colour(rim ? theme::paper : term_colour(about));
        const float width = (rim ? 6.5f : 3.0f) * ui.unit;
        for (std::size_t i = 0; i < pieces; ++i) {
            const auto &from = line[i], &to = line[(i + 1) % count];
            if (!from || !to) continue;
            list.AddLine(*from, *to, ink, width);
            list.AddCircleFilled(*from, width / 2, ink);
            list.AddCircleFilled(*to, width / 2, ink);
        }
        if (!arrow || !line[count - 2] || !line[count - 1]) continue;
        const ImVec2 from = *line[count - 2], tip = *line[count - 1], d{tip.x - from.x, tip.y - from.y};
        const float length = std::hypot(d.x, d.y);
        if (length == 0) continue;
        const float head = (rim ? 13.0f : 11.0f) * ui.unit / length, half = 0.5f * head;
        const ImVec2 base{tip.x - d.x * head, tip.y - d.y * head};
        list.AddTriangleFilled(tip, {base.x - d.y * half, base.y + d.x * half},
                               {base.x + d.y * half, base.y - d.x * half}, ink);
    }
}

}  // namespace sightline
