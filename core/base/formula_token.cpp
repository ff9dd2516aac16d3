// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/formula_token.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>

namespace sightline {

namespace {

// Longer ones first: "<=" begins like "<".
constexpr std::string_view signs[] = {"<=", ">=", "==", "!=", "&&", "||", "<", ">", "+", "-",
                                      "*",  "/",  "^",  "!",  "?",  ":",  "(", ")", ",", "="};

struct Hint {
    std::string_view word, instead;
};
constexpr Hint hints[] = {{"=", "=="},  {"&", "&&"},           {"|", "||"},      {"and", "&&"}, {"or", "||"},
                          {"not", "!"}, {"abs", "max(x, -x)"}, {"pow", "x ^ 2"}, {"true", "1"}, {"false", "0"}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

Token next_token(std::string_view text, std::size_t from) {
    while (from < text.size() && is_blank(text[from])) ++from;
    const std::string_view rest = text.substr(from);
    Token token{TokenKind::end, rest.substr(0, 0), from, 0};
    if (rest.empty()) return token;
    std::size_t size = 1;
    if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1]))) {
        token.kind = TokenKind::number;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), token.number);
        size = static_cast<std::size_t>(end - rest.data());
        if (error != std::errc()) token.number = std::numeric_limits<double>::quiet_NaN();
    } else if (is_letter(rest[0])) {
        token.kind = TokenKind::word;
        while (size < rest.size() && (is_letter(rest[size]) || is_digit(rest[size]))) ++size;
    } else {
        const auto sign =
            std::find_if(std::begin(signs), std::end(signs), [&](std::string_view s) { return rest.starts_with(s); });
        token.kind = sign == std::end(signs) ? TokenKind::unknown : TokenKind::sign;
        if (sign != std::end(signs))
            size = sign->size();
        else  // a whole character of UTF-8
            while (size < rest.size() && (static_cast<unsigned char>(rest[size]) & 0xc0) == 0x80) ++size;
    }
    token.text = rest.substr(0, size);
    return token;
}

std::string_view written_instead(std::string_view word) {
    const auto found = std::find_if(std::begin(hints), std::end(hints), [&](const Hint& h) { return h.word == word; });
    return found == std::end(hints) ? std::string_view() : found->instead;
}

}  // namespace sightline
