// Workbenches without a window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shell/desk/moved.h"
#include "tests/session/session_support.h"

namespace sightline::test {

/// A workbench that keeps what it says.
struct Bench {
    explicit Bench(Session<2> session) : bench{std::move(session)} {
        bench.say = [this](const std::string& line) { said.push_back(line); };
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    std::vector<std::string> said;
    Workbench<2> bench;
};

/// As the window has it: the whole run recorded.
inline void record_ahead(Workbench<2>& bench) {
    bench.record_ahead = true;
    traversal_changed(bench);
}

}  // namespace sightline::test
