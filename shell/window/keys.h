// Keys as the command table writes them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SDL_events.h>

#include <string>
#include <string_view>
#include <vector>

namespace sightline {

/// "Ctrl+Shift+Z", "Right", "]"; empty for modifiers and for keys without a name. Characters that lie elsewhere on
/// other keyboards are taken from text events, letters and the rest from key events: an event of the other kind is
/// empty.
std::string key_name(const SDL_Event& event);

/// One key of a command and what it runs: "Shift+Right=10" of `step` is {"Shift+Right", "step 10"}.
struct KeyBinding {
    std::string key;
    std::string command;  ///< with its argument
    bool asks = false;    ///< the argument has to be typed
};

/// The bindings of one command's `keys`.
std::vector<KeyBinding> key_bindings(std::string_view id, std::string_view keys);

}  // namespace sightline
