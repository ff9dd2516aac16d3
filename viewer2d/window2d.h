// The 2D viewer's window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/bench/workbench.h"

namespace sightline {

/// Opens the window on the bench and stays until the person quits. Throws WorkError without a display or OpenGL 3.3.
void run_window(Workbench<2>& bench);

}  // namespace sightline
