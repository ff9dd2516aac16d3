// Notes of authors and lecturers, as shapes and labels.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
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

/// The letter or two that a text note gives a cell, as in figures that speak of A and B; else its number.
template <int D>
std::string cell_letter(std::span<const Note<D>> notes, std::uint32_t cell);
template <int D>
std::string cell_letter(const std::vector<Note<D>>& notes, std::uint32_t cell) {
    return cell_letter<D>(std::span(notes), cell);
}

/// A short name beside a line, which yields to all else that is written.
void name_line(const Vec<2>& at, std::string name, DrawList& list, const Colours& colours);

/// Adds the current notes, a label for each in their order, where `place` puts their anchors; nothing for those that it
/// puts nowhere. Pictures have these labels before all others.
template <int D>
void draw_notes(const Session<D>& session, const std::function<std::optional<Vec<2>>(const Vec<D>&)>& place,
                const Colours& colours, std::uint16_t style, DrawList& list);

}  // namespace sightline
