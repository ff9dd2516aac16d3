// Changes of settings, views and scenes: remembered for undo, and said where they move the traversal.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>

#include "shell/desk/workbench.h"

namespace sightline {

enum class SetBy : std::uint8_t { hand, recommendation };

/// "auto is off: the budget was set by hand"; empty where method, cells and budget are the same.
std::string left_auto(const Settings& recommended, const Settings& settings);

/// `gesture` as remember() takes it. By hand it says what became of the traversal when it was made again, and the
/// setting `auto` goes off where method, cells or budget become others; a recommendation is said by whoever made it.
/// Throws InputError for a method that does not exist or a setting that only a fresh load can change; then nothing has
/// changed.
template <int D>
void change_settings(Workbench<D>& bench, const Settings& settings, const std::string& gesture = "",
                     SetBy by = SetBy::hand);

/// The culling view; while frozen the display view. Throws InputError for an invalid view.
template <int D>
void change_view(Workbench<D>& bench, const ViewSpec<D>& view, const std::string& gesture = "");

/// The culling view, also while frozen: the traversal is made again, the display view stays. Throws like change_view.
template <int D>
void change_culling_view(Workbench<D>& bench, const ViewSpec<D>& view, const std::string& gesture = "");

/// Other primitives under the same view and settings. `numbers` has for each old primitive its new number, none where
/// it is gone, for the selection and the notes; empty: they keep their numbers.
template <int D>
void change_scene(Workbench<D>& bench, std::shared_ptr<const Scene<D>> scene, const std::string& gesture = "",
                  std::span<const std::uint32_t> numbers = {});

/// Puts another session on the bench, at its place in the run. There is no way back to the old one by undo.
template <int D>
void replace_session(Workbench<D>& bench, Session<D> session);

}  // namespace sightline
