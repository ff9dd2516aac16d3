// Events of the keyboard as the command table writes its keys.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SDL_events.h>

#include <string>

namespace sightline {

/// "Ctrl+Shift+Z", "Right", "]"; empty for modifiers and for keys without a name. Characters that lie elsewhere on
/// other keyboards are taken from text events, letters and the rest from key events: an event of the other kind is
/// empty.
std::string key_name(const SDL_Event& event);

}  // namespace sightline
