// Keys as the command table writes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sightline {

/// One key of a command and what it runs: "Shift+Right=10" of `step` is {"Shift+Right", "step 10"}.
struct KeyBinding {
    std::string key;
    std::string command;  ///< with its argument
    bool asks = false;    ///< the argument has to be typed
};

/// The bindings of one command's `keys`.
std::vector<KeyBinding> key_bindings(std::string_view id, std::string_view keys);

}  // namespace sightline
