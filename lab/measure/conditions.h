// Under what the numbers of a study hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sightline::lab {

struct Conditions {
    std::string study;     ///< study_json, or another JSON object of one line
    std::string build;     ///< compiler and kind of build
    std::string program;   ///< hash of the program file: equal for one build
    std::string machine;   ///< processor and cores
    std::string renderer;  ///< OpenGL; empty for 2D alone
    std::string date;      ///< YYYY-MM-DD
};

/// This build and machine.
Conditions conditions_here(std::string study, std::string renderer);

/// As files of results have them: a JSON object.
std::string conditions_json(const Conditions& conditions);

}  // namespace sightline::lab
