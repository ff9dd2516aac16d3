// Sessions from the names of scenes; no bench is needed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/session/session.h"
#include "shell/desk/graphics.h"

namespace sightline {

/// The scene that a bare start shows.
inline constexpr const char* first_scene = "bottleneck";

/// The text of a state file; nothing when the name is that of a scene.
template <int D = 2>
std::optional<std::string> state_text(const std::string& name);

/// What a scene starts with: the catalogue's settings, or the defaults for a file.
/// In a 2D window the front is numbered, so that a step can be followed.
template <int D = 2>
Settings start_settings(const std::string& name, bool in_window = false);

/// Another view than a scene's start view.
template <int D>
using ChooseView = std::function<ViewSpec<D>(const ViewSpec<D>& start, const Scene<D>& scene)>;

/// Loads a scene by any name that load_scene takes and stays at step 0 of its start view, or of what `look` makes of
/// it. `warn` gets a line for each thing that was left out or looks odd. `cells`: the file that its tessellation comes
/// from (cells_file.h), empty for none. `choose_view`: false where `look` needs no start view.
/// Throws InputError, also for cells that do not fit.
template <int D>
Session<D> open_scene(const std::string& name, const Settings& settings, std::span<const Method<D>> methods,
                      const std::function<void(const std::string&)>& warn, const Graphics& graphics = {},
                      const std::string& cells = "", const ChooseView<D>& look = {}, bool choose_view = true);

/// The bookmarks of the session's catalogue row: conditions there, steps here.
template <int D>
void add_bookmarks(Session<D>& session);

/// The scene read again as these settings ask; the same one where they do not matter to it.
template <int D>
std::shared_ptr<const Scene<D>> reread(const std::shared_ptr<const Scene<D>>& scene, const Settings& settings);

}  // namespace sightline
