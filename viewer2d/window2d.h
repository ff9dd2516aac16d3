// The 2D viewer's window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "shell/bench/workbench.h"
#include "shell/window/stage.h"
#include "shell/window/window.h"

namespace sightline {

/// The picture and the scenes of the 2D viewer, for a window whose OpenGL context is current. The bench must live
/// longer.
Stage stage2d(Workbench<2>& bench);

/// Opens the window on the bench and stays until the person quits; then, and whenever a scene was opened, the file
/// keeps what the next start recalls. `word` is said first. Throws WorkError without a display or OpenGL 3.3.
void run_window(Workbench<2>& bench, const WindowOptions& options, const std::filesystem::path& memory,
                const std::string& word);

}  // namespace sightline
