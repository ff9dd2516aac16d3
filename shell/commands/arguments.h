// Arguments of commands, from the words that people type.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "shell/desk/workbench.h"

namespace sightline {

/// What a command gets after its id.
using Text = const std::string&;

/// "first rest" -> {first, rest}
std::array<std::string, 2> split_word(Text text);

/// Throws InputError "'text' is not WHAT".
std::uint32_t whole_argument(Text text, const char* what);
double number_argument(Text text, const char* what);

/// One of the words of an enum. Throws InputError that lists them.
std::size_t word_argument(Text text, std::span<const std::string_view> words);

/// "FROM-TO"; nothing for what is none.
std::optional<std::array<std::uint32_t, 2>> parse_steps(std::string_view text);

/// "X,Y", two numbers; nothing for what is none.
std::optional<Vec<2>> parse_pair(std::string_view text);

/// Throws InputError when there is no name.
const std::string& file_argument(Text text);

/// A number, "last" (the cell of the last step) or "selected". Throws InputError when there is no such cell.
template <int D>
std::uint32_t cell_argument(const Workbench<D>& bench, Text text);

/// A number or "last". Throws InputError when the method's tree has no such box.
template <int D>
std::uint32_t node_argument(const Workbench<D>& bench, Text text);

/// A number or "selected". Throws InputError when there is no such primitive.
template <int D>
std::uint32_t primitive_argument(const Workbench<D>& bench, Text text);

/// A number from 1, or "selected"; the index of the note. Throws InputError when there is no such note.
template <int D>
std::uint32_t note_argument(const Workbench<D>& bench, Text text);

/// A point of the scene's file, as people write it ("X,Y"), in the coordinates of the session.
template <int D>
Vec<D> parse_point(Text text, const Scene<D>& scene);

/// The same point as people write it.
template <int D>
std::string point_text(const Vec<D>& point, const Scene<D>& scene);

}  // namespace sightline
