// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/quote.h"

#include <algorithm>

#include "core/base/text.h"

namespace sightline {

namespace {

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

std::string spaced_lines(std::string_view text) {
    std::string line = clean_text(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

}  // namespace

std::string gnuplot_quoted(std::string_view text) {
    std::string quoted = "'";
    for (const char c : spaced_lines(text)) {
        // gnuplot 5.4 ends a string at a doubled quote that stands first or behind another, and looks for macros behind
        // "'": a string that is to be safe has none in it. It puts '>' into SVG as it is, where ]]> would end CDATA.
        if (c == '\'')
            quoted += "\u2019";
        else if (c == '>' && quoted.ends_with("]]"))
            quoted += " >";
        else
            quoted += c;
    }
    return quoted + "'";
}

std::string shell_quoted(std::string_view word) {
    static constexpr std::string_view plain = "-_./:=,%@+";
    const bool is_plain = !word.empty() && word.front() != '=' && std::all_of(word.begin(), word.end(), [](char c) {
        return is_letter_or_digit(c) || plain.find(c) != std::string_view::npos;
    });
    if (is_plain) return std::string(word);
    std::string quoted;
    if (spaced_lines(word) == word) {
        quoted = "'";
        for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        return quoted + "'";
    }
    // Line feeds, other control characters and broken UTF-8 would not come through a page or a terminal.
    quoted = "$'";
    for (const char c : word) {
        const auto byte = static_cast<unsigned char>(c);
        if (is_letter_or_digit(c) || plain.find(c) != std::string_view::npos || c == ' ') {
            quoted += c;
        } else if (byte != 0) {
            quoted += '\\';
            for (const int shift : {6, 3, 0}) quoted += static_cast<char>('0' + (byte >> shift & 7));
        }
    }
    return quoted + "'";
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : clean_text(text)) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else if (c == '\'')
            out += "&#39;";
        else
            out += c;
    }
    return out;
}

std::string markdown_escaped(std::string_view text) {
    std::string out;
    for (const char c : spaced_lines(text)) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (std::string_view("\\`*_[]|~$").find(c) != std::string_view::npos)
            out += {'\\', c};
        else
            out += c;
    }
    return out;
}

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += c;
        quoted += c;
    }
    return quoted + "\"";
}

std::string base64(std::string_view data) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((data.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < data.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < data.size() ? static_cast<unsigned char>(data[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k) out += k <= data.size() - i ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

}  // namespace sightline
