// Scenes and state files onto the bench.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shell/desk/open_scene.h"
#include "shell/desk/workbench.h"

namespace sightline {

/// Puts a scene (by any name) or a state file (by its name) on the bench. Where `auto` is on, it stays on for a scene,
/// and what is recommended for that is chosen; a state has its own. Throws InputError; then nothing has changed.
template <int D>
void open(Workbench<D>& bench, const std::string& name);

/// The same with the settings that the scene or the state begins with, whatever is recommended: `auto` is off.
template <int D>
void open_as_it_is(Workbench<D>& bench, const std::string& name);

/// The same for the text of a state file; `name` begins error lines.
template <int D>
void open_state_text(Workbench<D>& bench, const std::string& text, const std::string& name);

/// Compares with what a scene or a state file holds. Throws InputError; then nothing has changed.
template <int D>
void compare_file(Workbench<D>& bench, const std::string& name);

}  // namespace sightline
