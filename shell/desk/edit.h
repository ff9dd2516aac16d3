// Editing the segments of the scene on the bench. An edited scene keeps its id and title; its source is "edited", so
// that nothing takes it for the original.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shell/desk/workbench.h"

namespace sightline {

/// Segments are in the session's coordinates; `gesture` is as remember() takes it. Selection and notes keep meaning the
/// same segments. Each throws InputError for a segment of zero length, one that is there already and coordinates that
/// are not finite or too large; then nothing has changed.

/// Adds and selects it.
void add_segment(Workbench<2>& bench, const Primitive<2>& segment, const std::string& gesture = "");
void move_segment(Workbench<2>& bench, std::uint32_t index, const Primitive<2>& segment,
                  const std::string& gesture = "");
void delete_segment(Workbench<2>& bench, std::uint32_t index);

/// An empty scene, looked at from its middle, without notes and bookmarks. Undo brings the old one back.
void new_scene(Workbench<2>& bench);

/// Writes the scene with the view of now as its start view; reading it gives the same segments, bit for bit.
void save_scene(const Workbench<2>& bench, const std::string& file);

}  // namespace sightline
