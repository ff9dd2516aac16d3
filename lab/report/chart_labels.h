// Where labels stand beside the points of a chart: none is left out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

namespace sightline::lab {

/// A label of the point at x, y (pixels, y upwards).
struct ChartLabel {
    std::string text;
    double x = 0, y = 0;
};

/// Where it stands: the middle of its left, right or centre, by `side` -1, 1 and 0: text to the left of x, to the
/// right, about it.
struct LabelPlace {
    double x = 0, y = 0;
    int side = 1;
    bool shared = false;  ///< the same text stands at a point so near that one will do
};

/// One place for each, in turn: the first of twelve about its point where it covers neither another label nor one of
/// the points, else that where it covers least; `lines` are points of
/// lines, which may rather be covered. `font`: size of the letters in pixels.
std::vector<LabelPlace> place_labels(const std::vector<ChartLabel>& labels,
                                     const std::vector<std::array<double, 2>>& points,
                                     const std::vector<std::array<double, 2>>& lines, double font);

}  // namespace sightline::lab
