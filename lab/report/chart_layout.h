// Where the parts of a chart stand: axes, their words, the key.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lab/report/chart.h"

namespace sightline::lab {

/// The middle of its first piece of line's left end, from the lower left corner of the chart; its name.
struct KeyEntry {
    double x = 0, y = 0;
    std::vector<std::string> lines;
};

/// Everything's place in pixels, so that nothing is left out for want of room. Margins are those of the axes.
struct ChartLayout {
    std::vector<std::string> title, x, y;
    bool key_below = false;
    double height = 0, left = 0, right = 0, top = 0, bottom = 0;
    std::vector<KeyEntry> key;  ///< of the series that have a name, in their order
};

/// The key is at the side of the axes, or under them where it is too high for that or would leave them too narrow.
ChartLayout layout_of(const Chart& chart, const ChartFormat& format, const AxisRange& y_range);

/// Of several lines, for gnuplot.
std::string lines_quoted(const std::vector<std::string>& lines);

/// Letters, not bytes.
std::size_t characters_of(const std::string& text);

}  // namespace sightline::lab
