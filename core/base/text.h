// Text as bytes: error lines of one form, UTF-8.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace sightline {

/// The text on one line: control characters become '?', and what is beyond `most` bytes is cut with "...".
std::string one_line(std::string_view text, std::size_t most = 160);

/// "name: place: reason" on one line; the place may be empty.
InputError input_error(std::string_view name, std::string_view place, std::string_view reason);

/// "line 3, column 14" of a byte offset; both count from 1, columns in bytes.
std::string line_and_column(std::string_view text, std::size_t offset);

/// The length of the UTF-8 character at `at`, or 0 when the bytes there are none.
std::size_t character_length(std::string_view text, std::size_t at);

/// Valid UTF-8: broken bytes become U+FFFD, tabs a space, other control characters but line feeds vanish.
std::string clean_text(std::string_view text);

/// "1 facet", "3 facets", "3 boxes", "3 entries".
std::string counted(std::size_t n, std::string_view what);

/// "segment 7", "segments 7, 9 and 3 more": so many of the ids, at least one of which there is.
std::string some_of(std::string_view what, std::span<const std::uint32_t> ids, std::size_t most);

/// The word that a mistyped one most likely stands for: few letters to put in, take out or change. Empty: none.
std::string_view closest(std::string_view mistyped, std::span<const std::string_view> words);

/// "setting 'penalti' does not exist; did you mean penalty?", or all words where none is close.
InputError unknown_word(std::string_view kind, std::string_view word, std::span<const std::string_view> words);

}  // namespace sightline
