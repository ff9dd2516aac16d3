// The 3D viewer as a function, so that a program with one more method in its table is the same viewer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/methods/method_table.h"

namespace sightline {

/// Parses the options, obeys them, writes the files. Returns the exit status: 0 done, 1 failed while working, 2 wrong
/// usage or unreadable input (one line on standard error).
int viewer3d(int argc, const char* const* argv, std::span<const Method<3>> methods = method_table<3>());

}  // namespace sightline
