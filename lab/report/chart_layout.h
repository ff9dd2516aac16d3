// Where the parts of a chart stand: axes, their words, the key.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lab/report/chart.h"

namespace sightline::lab {

/// Everything's place in pixels, so that nothing is left out for want of room. Margins are those of the axes.
struct ChartLayout {
    std::vector<std::string> title, x, y;
    bool key_below = false;
    int key_columns = 1;
    double height = 0, left = 0, right = 0, top = 0, bottom = 0, key_top = 0;
};

/// The key is at the side of the axes, or under them where that would leave them too narrow.
ChartLayout layout_of(const Chart& chart, const ChartFormat& format, const AxisRange& y_range);

/// Letters, not bytes.
std::size_t characters_of(const std::string& text);

}  // namespace sightline::lab
