// A study as a page of documentation: tables and trade-offs with their conditions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "lab/measure/results.h"

namespace sightline::lab {

/// Writes `file` and beside it images/results-*.svg, the trade-offs. `command` is what made it, as a shell takes it.
/// Throws WorkError.
void write_markdown(const Results& results, const std::string& command, const std::filesystem::path& file);

}  // namespace sightline::lab
