// Inside core/scene: what the floor plans of failure scenes are made of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/make/sketch.h"

namespace sightline::failures {

/// A wall in `count` pieces of one length: a budget of a few primitives must not show all of one.
inline void pieces(Sketch& sketch, const Vec<2>& a, const Vec<2>& b, int count) {
    for (int i = 0; i < count; ++i)
        sketch.line(a + (b - a) * (static_cast<double>(i) / count),
                    i + 1 == count ? b : a + (b - a) * (static_cast<double>(i + 1) / count));
}

/// Crates in rows, their sides about `share` of the spacing.
inline void crate_rows(Sketch& sketch, Random& random, const RoomPlan& area, double spacing, double share) {
    for (double y = area.y0 + spacing / 2; y + spacing / 2 <= area.y1; y += spacing)
        for (double x = area.x0 + spacing / 2; x + spacing / 2 <= area.x1; x += spacing) {
            const double side = spacing * share * random.uniform(0.8, 1.2);
            const double dx = random.uniform(-0.1, 0.1), dy = random.uniform(-0.1, 0.1);
            crate(sketch, random, {x + dx * spacing, y + dy * spacing}, side);
        }
}

}  // namespace sightline::failures
