// Notes of authors and lecturers, as shapes and labels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/draw/palette.h"
#include "core/session/session.h"

namespace sightline {

/// The point that a note is about.
template <int D>
Vec<D> anchor_point(const Session<D>& session, const Note<D>& note);

/// The notes whose step range holds the session's position.
template <int D>
std::vector<Note<D>> current_notes(const Session<D>& session);

/// Adds the current notes, a label for each in their order, where `place` puts their anchors; nothing for those that it
/// puts nowhere. Pictures have these labels before all others.
template <int D>
void draw_notes(const Session<D>& session, const std::function<std::optional<Vec<2>>(const Vec<D>&)>& place,
                const Colours& colours, std::uint16_t style, DrawList& list);

}  // namespace sightline
