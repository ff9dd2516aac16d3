// What a file holds, told by its first bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sightline {

/// "a PNG picture", where the file begins like a format that its ending does not stand for; nothing where it does not,
/// where it begins like none that is known, and where it cannot be read.
std::string kind_behind(const std::string& path);

}  // namespace sightline
