// Editing the segments of the scene on the bench. An edited scene keeps its id and title; its source is "edited", so
// that nothing takes it for the original.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
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

/// Takes away what lies between the two points of a segment that are nearest to `from` and `to`, and selects what is
/// left of it. `before` is the scene to cut: while a drag goes on, the one that it began with. What lies before the gap
/// keeps the number, what lies behind it gets a new one; ends that are left keep their coordinates bit for bit. Throws
/// InputError where nothing would be left out.
void cut_gap(Workbench<2>& bench, const std::shared_ptr<const Scene<2>>& before, std::uint32_t index,
             const Vec<2>& from, const Vec<2>& to, const std::string& gesture = "");

/// The point of the segment that is nearest to `at`.
Vec<2> nearest_on(const Primitive<2>& segment, const Vec<2>& at);

/// An empty scene, looked at from its middle, without notes and bookmarks. Undo brings the old one back.
void new_scene(Workbench<2>& bench);

/// Writes the scene with the view of now as its start view; reading it gives the same segments, bit for bit.
void save_scene(const Workbench<2>& bench, const std::string& file);

}  // namespace sightline
