// The lab as a person runs it, inside a test.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "lab/command.h"

namespace sightline::lab::test {

/// The exit status of `lab COMMAND WORDS…`, and what it printed, standard error last.
inline std::pair<int, std::string> run_lab(const std::string& command, std::vector<std::string> words) {
    words.insert(words.begin(), {"lab", command});
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int status = lab_program(static_cast<int>(argv.size()), argv.data());
    return {status, testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr()};
}

}  // namespace sightline::lab::test
