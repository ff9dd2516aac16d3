// Runs the parts of a task side by side.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace sightline {

/// Calls `part` with 0 to count - 1, each once, in any order, on up to `threads` threads (0: as many as the machine
/// has); returns when all are done. The first exception is thrown on. Where no thread can be had, the caller does all.
void run_parts(int count, int threads, const std::function<void(int)>& part);

}  // namespace sightline
