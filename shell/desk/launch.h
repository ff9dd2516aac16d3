// Starting the other viewer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sightline {

/// Starts a program that lies beside this one, with one argument or none, and does not wait for it. Throws
/// InputError when there is none, WorkError when it cannot be started.
void launch(const std::string& program, const std::string& argument);

}  // namespace sightline
