// Progress for a person who waits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sightline::lab {

/// On standard error: over one line at a terminal, else a line each. An empty one ends the progress.
void say(const std::string& text);

/// "lab: warning: text", a line of its own on standard error.
void warn(const std::string& text);

/// From now on an interrupt (Ctrl+C, SIGTERM) is only noted; interrupted() tells.
void note_interrupts();
bool interrupted();
/// Says that the same command goes on where it was; the exit status for that.
int stopped();

}  // namespace sightline::lab
