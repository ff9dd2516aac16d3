// Notes of authors and lecturers, as shapes and labels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/draw_list.h"
#include "core/draw/palette.h"
#include "core/session/session.h"

namespace sightline {

/// The point that a note is about.
Vec<2> anchor_point(const Session<2>& session, const Note<2>& note);

/// The notes whose step range holds the session's position.
std::vector<Note<2>> current_notes(const Session<2>& session);

/// Adds the current notes, a label for each in their order. Pictures have these labels before all others.
void draw_notes(const Session<2>& session, const Colours& colours, std::uint16_t style, DrawList& list);

}  // namespace sightline
