// Other programs, started without a shell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sightline {

/// Runs words[0], found as a shell finds it, with the others as arguments and waits for it; what it prints goes
/// nowhere. Throws WorkError with its first line of complaint when it fails, and with the Debian package `package` when
/// it is not there.
void run_program(std::vector<std::string> words, const std::string& package);

}  // namespace sightline
