// Lines that break at spaces only: ImGui breaks after a point too, in the middle of a number.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace sightline {

/// `text` with line breaks in place of spaces, so that no line is wider than `width` unless it is a single word.
/// `width_of(string_view)` measures a line.
template <typename WidthOf>
std::string wrapped_at_spaces(std::string_view text, double width, const WidthOf& width_of) {
    std::string lines;
    std::size_t line = 0;  // where the last one begins
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(" \n", 1), text.size());
        const std::size_t before = lines.size();
        lines += text.substr(0, end);  // a word and what stands before it
        text.remove_prefix(end);
        const bool too_wide = before > line && width_of(std::string_view(lines).substr(line)) > width;
        if (too_wide && lines[before] == ' ') lines[before] = '\n';
        if (lines[before] == '\n') line = before + 1;
    }
    return lines;
}

/// `text`, or where that is wider than `width` as much of its beginning as fits with "…" behind it; at least "…".
template <typename WidthOf>
std::string shortened(std::string_view text, double width, const WidthOf& width_of) {
    if (width_of(text) <= width) return std::string(text);
    std::string shown;
    do {
        std::size_t end = text.size() - 1;
        while (end > 0 && (text[end] & 0xc0) == 0x80) --end;  // whole characters only
        text = text.substr(0, end);
        while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
        shown = std::string(text) + "…";
    } while (!text.empty() && width_of(shown) > width);
    return shown;
}

}  // namespace sightline
