// What was opened lately, for menus and for the next start.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sightline {

/// Most names that are kept.
inline constexpr std::size_t most_recent = 10;

/// Puts what `open` took in front of the list, files with their whole path.
template <int D>
void note_opened(std::vector<std::string>& recent, const std::string& name);

/// The list of a window and the one that another window wrote meanwhile, when both knew `known`: what was opened here
/// comes first, then what was opened there; what was dropped here stays dropped.
std::vector<std::string> merge_recent(const std::vector<std::string>& ours, const std::vector<std::string>& theirs,
                                      const std::vector<std::string>& known);

}  // namespace sightline
