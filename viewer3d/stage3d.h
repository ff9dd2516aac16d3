// What the 3D viewer puts into the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "shell/desk/workbench.h"
#include "shell/window/stage.h"
#include "viewer3d/renderers.h"

namespace sightline {

/// The picture and the scenes of the 3D viewer, for a window whose OpenGL context is current; the renderers are dropped
/// with the stage. The bench must live longer.
Stage stage3d(Workbench<3>& bench, const std::shared_ptr<Renderers>& renderers);

}  // namespace sightline
