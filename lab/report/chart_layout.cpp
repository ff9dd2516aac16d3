// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/chart_layout.h"

#include <algorithm>
#include <cmath>

#include "core/base/quote.h"

namespace sightline::lab {

std::size_t characters_of(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

namespace {

/// Lines of at most so many characters, broken between words.
std::vector<std::string> wrapped(const std::string& text, double most) {
    std::vector<std::string> lines{""};
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        at = end + 1;
        std::string& line = lines.back();
        if (!line.empty() && static_cast<double>(characters_of(line) + 1 + characters_of(word)) > most)
            lines.push_back(word);
        else
            line += (line.empty() ? "" : " ") + word;
    }
    return lines;
}

double tic_characters(const AxisRange& range, bool log) {
    if (log) return 6;
    const double size = std::max(std::abs(range.from), std::abs(range.to)), span = range.to - range.from;
    return std::max(size >= 1e5   ? 6.0
                    : size >= 1e4 ? 5.0
                    : size >= 1e3 ? 4.0
                                  : 3.0,
                    span < 0.1 ? 6.0
                    : span < 5 ? 4.0
                               : 0);
}

}  // namespace

std::string lines_quoted(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : ".\"\\n\".") + gnuplot_quoted(line);
    return text.empty() ? "''" : text;
}

ChartLayout layout_of(const Chart& chart, const ChartFormat& format, const AxisRange& y_range) {
    const double f = format.font, letter = 0.58 * f, line = 1.3 * f;
    std::size_t longest = 0;
    std::vector<std::string> names;
    for (const Series& s : chart.series) {
        if (s.name.empty()) continue;
        longest = std::max(longest, characters_of(s.name));
        names.push_back(s.name);
    }
    ChartLayout at;
    const double key = letter * static_cast<double>(longest) + 5 * f, row = 1.25 * f;
    at.key_below = key > 0.36 * format.width || row * static_cast<double>(names.size()) > 0.8 * format.height;
    at.y = wrapped(chart.y, 0.8 * format.height / letter);
    at.left = line * static_cast<double>(at.y.size()) + letter * tic_characters(y_range, chart.log_y) + 2 * f;
    at.right = at.key_below ? 1.8 * f : key + f;
    at.x = wrapped(chart.x, (format.width - at.left - at.right) * (at.key_below ? 1.15 : 1.05) / letter);
    if (format.titles) at.title = wrapped(chart.title, 0.95 * format.width / letter);
    at.top = line * static_cast<double>(at.title.size()) + (format.titles ? 1.6 : 0.9) * f;
    const auto columns = at.key_below
                             ? std::clamp<std::size_t>(static_cast<std::size_t>((format.width - f) / key), 1, 4)
                             : std::size_t{1};
    // A name that is wider than the chart has several lines.
    double rows = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const bool alone = at.key_below && columns == 1;
        at.key.push_back({0, 0, alone ? wrapped(names[i], (format.width - 5 * f) / letter) : std::vector{names[i]}});
        at.key.back().y = rows + 0.5 * static_cast<double>(at.key.back().lines.size());
        if ((i + 1) % columns == 0 || i + 1 == names.size()) rows += static_cast<double>(at.key.back().lines.size());
    }
    const double below = at.key_below ? row * rows + 0.8 * f : 0;
    at.bottom = 2.2 * f + line * static_cast<double>(at.x.size()) + below;
    at.height = format.height + below;
    const double left = at.key_below ? std::max((format.width - static_cast<double>(columns) * key) / 2, 0.5 * f)
                                     : format.width - at.right + f;
    const double top = at.key_below ? below - 0.3 * f : at.height - at.top;
    for (std::size_t i = 0; i < names.size(); ++i) {
        at.key[i].x = left + key * static_cast<double>(i % columns);
        at.key[i].y = top - row * at.key[i].y;
    }
    return at;
}

}  // namespace sightline::lab
