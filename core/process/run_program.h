// Other programs, started without a shell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sightline {

/// Runs words[0], found as a shell finds it, with the others as arguments and waits for it; what it prints goes
/// nowhere. It starts in `folder`, so that its words need not name one that it could take for something else: programs
/// know pipes, protocols, patterns and options by how a name begins. Throws WorkError with its first line of complaint
/// when it fails, and with the Debian package `package` when it is not there.
void run_program(std::vector<std::string> words, const std::string& package, const std::filesystem::path& folder = ".");

}  // namespace sightline
