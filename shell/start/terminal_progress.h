// How far reading a scene is, for a person at a terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

namespace sightline {

/// Writes over one line of standard error, from half a second on; empty where that is no terminal.
Progress terminal_progress();

}  // namespace sightline
