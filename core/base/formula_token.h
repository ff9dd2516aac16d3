// The words of a formula's text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace sightline {

enum class TokenKind { end, number, word, sign, unknown };

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;
    std::size_t at = 0;  ///< in the whole text
    double number = 0;   ///< NaN: too large or too small for a double
};

/// The first token that begins at or after `from`.
Token next_token(std::string_view text, std::size_t from);

/// What stands in formulas for a word or sign that people know from elsewhere. Empty: nothing is known.
std::string_view written_instead(std::string_view word);

}  // namespace sightline
