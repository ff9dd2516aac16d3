// Notes of authors and lecturers, as shapes and labels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/draw_list.h"
#include "core/draw/palette.h"
#include "core/session/session.h"

namespace sightline {

/// Adds the notes whose step range holds the session's position.
void draw_notes(const Session<2>& session, const Colours& colours, std::uint16_t style, DrawList& list);

}  // namespace sightline
