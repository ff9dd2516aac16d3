// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/panels/id_link.h"

#include <array>
#include <optional>

namespace sightline {

namespace {

struct LinkWord {
    std::string_view word, command;
};
constexpr std::array kinds{LinkWord{"cell", "select "},
                           LinkWord{"step", "seek "},
                           LinkWord{"triangle", "select primitive:"},
                           LinkWord{"segment", "select primitive:"},
                           LinkWord{"primitive", "select primitive:"},
                           LinkWord{"node", "select node:"},
                           LinkWord{"box", "select node:"}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view command_of(std::string_view word) {
    for (const LinkWord& kind : kinds) {
        std::string_view rest = word;
        if (rest.empty() || (rest[0] | 0x20) != kind.word[0]) continue;
        rest.remove_prefix(1);
        if (!rest.starts_with(kind.word.substr(1))) continue;
        rest.remove_prefix(kind.word.size() - 1);
        if (rest.empty() || rest == "s" || rest == "es") return kind.command;
    }
    return {};
}

}  // namespace

IdLink id_link_at(std::string_view text, std::size_t at) {
    std::string_view command;  // of the word that the numbers which follow belong to
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        if (is_letter(text[i])) {
            while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
            const std::string_view word = text.substr(i, end - i);
            if (word != "and" && word != "to") command = command_of(word);
        } else if (is_digit(text[i])) {
            while (end < text.size() && (is_digit(text[end]) || text[end] == '.')) ++end;
            const std::string_view number = text.substr(i, end - i);
            const std::size_t after = text.find_first_not_of(" \n", end);
            const bool share = after != text.npos && text[after] == '%';
            const std::string_view digits = number.substr(0, number.find_last_not_of('.') + 1);  // "cell 4."
            if (at >= i && at < i + digits.size() && !command.empty() && !share && digits.find('.') == digits.npos)
                return {i, digits.size(), std::string(command) + std::string(digits)};
        } else if (text[i] == ':' || text[i] == ';' || text[i] == '=') {
            command = {};
        }
        i = end;
    }
    return {};
}

}  // namespace sightline
