// What and when: the conditions of a measured time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sightline {

/// Processor and cores, as "Intel Xeon, 2 cores".
std::string machine_text();

/// YYYY-MM-DD, in UTC.
std::string today_text();

}  // namespace sightline
