// What a half-typed command line may become.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "shell/desk/workbench.h"

namespace sightline {

struct Completion {
    std::size_t from = 0;            ///< the word that is being typed begins here
    std::vector<std::string> words;  ///< that it may become, in alphabetical order; each begins with what is typed
};

/// Of the last word of the line: commands, and what the command before it takes (methods, settings and their values,
/// panels, scenes, files, lessons, terms).
template <int D>
Completion completions(const Workbench<D>& bench, const std::string& line);

/// The line with the longest beginning that all words share; with a space behind the only one.
std::string completed(const std::string& line, const Completion& completion);

}  // namespace sightline
