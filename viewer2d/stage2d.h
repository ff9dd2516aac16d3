// What the 2D viewer puts into the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/desk/workbench.h"
#include "shell/window/stage.h"

namespace sightline {

/// The picture and the scenes of the 2D viewer, for a window whose OpenGL context is current. The bench must live
/// longer.
Stage stage2d(Workbench<2>& bench);

}  // namespace sightline
