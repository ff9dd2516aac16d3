// A viewer from its command line to its end: what both have in common.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>

#include "shell/desk/workbench.h"
#include "shell/window/stage.h"

namespace sightline {

/// What is a viewer's own.
template <int D>
struct Viewer {
    std::string name;  ///< of the program
    std::function<void()> print_catalogue;
    /// Its picture and scenes, for a window whose OpenGL context is current. The bench lives longer.
    std::function<Stage(Workbench<D>&)> stage;
    Graphics graphics{};  ///< 3D
};

/// Parses the options, obeys them, writes the files, opens the window. Returns the exit status: 0 done, 1 failed while
/// working, 2 wrong usage or unreadable input (one line on standard error).
template <int D>
int start(int argc, const char* const* argv, std::span<const Method<D>> methods, const Viewer<D>& viewer);

}  // namespace sightline
