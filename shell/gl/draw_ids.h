// References by OpenGL, or in software where there is none.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "core/truth/id_image.h"
#include "shell/gl/id_renderer.h"

namespace sightline {

/// Draws with `renderer`, which may make the context first. Where that fails for want of OpenGL the rasteriser of core
/// draws, then and from then on, and `warn` is told so once.
DrawIds draw_ids_with(std::function<IdRenderer&()> renderer, std::function<void(const std::string& line)> warn);

}  // namespace sightline
