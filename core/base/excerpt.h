// Words from elsewhere (options, files, names) in error lines: short, plain, on one line.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sightline {

/// one_line() of at most 60 bytes: enough to know the words again.
std::string excerpt(std::string_view text);

/// A whole error line for a terminal: where it is long the middle goes, since the reason stands at its end.
std::string error_line(std::string_view text);

}  // namespace sightline
