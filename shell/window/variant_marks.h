// Lines and markers of variants as the window draws them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/variant_look.h"
#include "shell/window/ui.h"

namespace sightline {

/// Through the points, in the look's dashes, which go on round corners.
void draw_line(ImDrawList& list, std::span<const ImVec2> points, const VariantLook& look, float width);

/// Within about `radius` of a point; an open one on `paper`.
void draw_marker(ImDrawList& list, const ImVec2& centre, const VariantLook& look, float radius, const Colour& paper);

}  // namespace sightline
