// What the project's own readers make of a file, and the words that their text formats are made of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/utf8_mark.h"
#include "core/scene/scene.h"

namespace sightline {

/// Each reader takes the whole file and throws InputError "line 3: reason"; the place is left out where lines have no
/// meaning. Coordinates are the file's numbers as doubles. Memory beside the file: at most 200 bytes a triangle and as
/// much an object; that of triangles is known, and checked, before it is taken.
struct ParsedMesh {
    std::vector<Primitive<3>> triangles;
    Objects objects;
    std::vector<std::string> warnings;
    bool single_precision = false;  ///< the file holds floats, which may be far apart where it lies
};

/// Takes a share in [0, 1]; may be empty.
using ShareDone = std::function<void(double share)>;

inline constexpr std::string_view blanks = " \t\r\n\f\v";
inline bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// The next word of the text, which loses it; empty at the end.
inline std::string_view next_word(std::string_view& text) {
    std::size_t from = 0;
    while (from < text.size() && is_blank(text[from])) ++from;
    std::size_t to = from;
    while (to < text.size() && !is_blank(text[to])) ++to;
    const std::string_view word = text.substr(from, to - from);
    text.remove_prefix(to);
    return word;
}

/// The whole word as a number: also +1, 1e999 (infinite), nan and 1.#QNAN (not a number).
std::optional<double> number_in_file(std::string_view word);

/// The word in small letters.
std::string in_small_letters(std::string_view word);

/// "line 3: reason", for what stands at `at` in the text.
InputError error_at(std::string_view text, std::size_t at, const std::string& reason);

/// Throws InputError when the machine cannot hold that many triangles and points.
void check_memory(std::uint64_t triangles, std::uint64_t points);

}  // namespace sightline
