// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/base/excerpt.h"

namespace sightline {

std::string one_line(std::string_view text, std::size_t most) {
    std::string line(text.substr(0, most));
    if (text.size() > most) {
        while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xc0) == 0x80) line.pop_back();
        if (!line.empty() && static_cast<unsigned char>(line.back()) >= 0xc0) line.pop_back();  // half a character
    }
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t length = character_length(line, i);
        const auto byte = static_cast<unsigned char>(line[i]);
        // U+0080 to U+009F are commands to some terminals, as their single bytes are, which are no UTF-8.
        const bool control =
            byte < 0x20 || byte == 0x7f || (byte == 0xc2 && static_cast<unsigned char>(line[i + 1]) < 0xa0);
        if (length == 0 || control) line.replace(i, std::max<std::size_t>(length, 1), "?");
        i += length == 0 || control ? 1 : length;
    }
    return text.size() > most ? line + "..." : line;
}

InputError input_error(std::string_view name, std::string_view place, std::string_view reason) {
    // A long path must not hide the reason.
    std::string line = one_line(name, 4096) + ": ";
    if (!place.empty()) line += one_line(place) + ": ";
    return InputError(line + one_line(reason, 4096));
}

std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t last = before.rfind('\n');
    const std::size_t column = before.size() - (last == std::string_view::npos ? 0 : last + 1);
    return "line " + std::to_string(lines + 1) + ", column " + std::to_string(column + 1);
}

std::size_t character_length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(at);
    const std::size_t length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
    if (length == 0 || at + length > text.size()) return 0;
    unsigned code = length == 1 ? first : first & (0x7f >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (byte(at + i) >> 6 != 2) return 0;
        code = code << 6 | (byte(at + i) & 63);
    }
    constexpr std::array<unsigned, 5> least{0, 0, 0x80, 0x800, 0x10000};
    // XML and cairo take neither surrogates nor these two.
    if (code < least[length] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return 0;
    return code == 0xfffe || code == 0xffff ? 0 : length;
}

std::string clean_text(std::string_view text) {
    std::string clean;
    clean.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = character_length(text, i);
        const auto byte = static_cast<unsigned char>(text[i]);
        if (length == 0)
            clean += "\xEF\xBF\xBD";
        else if (byte == '\t')
            clean += ' ';
        else if (length > 1 || (byte >= 32 && byte != 127) || byte == '\n')
            clean += text.substr(i, length);
        i += std::max<std::size_t>(length, 1);
    }
    return clean;
}

namespace {

/// Damerau and Levenshtein's distance, by rows of its table: two letters that have changed places count one.
std::size_t letters_apart(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 0; i < a.size(); ++i) {
        before = above;
        above = row;
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            row[j + 1] = std::min({above[j] + (a[i] != b[j]), row[j] + 1, above[j + 1] + 1});
            const bool swapped = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
            if (swapped) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
        }
    }
    return row.back();
}

}  // namespace

std::string counted(std::size_t n, std::string_view what) {
    const std::string number = std::to_string(n) + " ";
    if (n != 1 && what.ends_with("ry")) return number + std::string(what.substr(0, what.size() - 1)) + "ies";
    return number + std::string(what) + (n == 1 ? "" : what.ends_with('x') || what.ends_with("sh") ? "es" : "s");
}

std::string some_of(std::string_view what, std::span<const std::uint32_t> ids, std::size_t most) {
    std::string text = std::string(what) + (ids.size() == 1 ? " " : "s ");
    for (std::size_t i = 0; i < std::min(most, ids.size()); ++i) text += (i > 0 ? ", " : "") + std::to_string(ids[i]);
    if (ids.size() > most) text += " and " + std::to_string(ids.size() - most) + " more";
    return text;
}

std::string_view closest(std::string_view mistyped, std::span<const std::string_view> words) {
    std::string_view best;
    std::size_t least = (mistyped.size() + 1) / 3 + 1;  // fewer than so many letters
    for (const std::string_view word : words) {
        const std::size_t apart = letters_apart(mistyped, word);
        if (apart >= least || apart >= word.size()) continue;
        best = word;
        least = apart;
    }
    // Half a word.
    for (const std::string_view word : words)
        if (best.empty() && mistyped.size() >= 3 && word.starts_with(mistyped)) best = word;
    return best;
}

InputError unknown_word(std::string_view kind, std::string_view word, std::span<const std::string_view> words) {
    std::string text = std::string(kind) + " '" + excerpt(word) + "' does not exist; ";
    if (const std::string_view close = closest(word, words); !close.empty())
        return InputError(text + "did you mean " + std::string(close) + "?");
    text += "there are ";
    for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : ", ") + std::string(words[i]);
    return InputError(text);
}

}  // namespace sightline
