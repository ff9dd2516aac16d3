// The swatch of a legend's row as a shape.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/draw/draw_list.h"

namespace sightline {

struct Swatch {
    std::vector<Vec<2>> points;
    double size_pt = 0;  ///< as Shape::size_pt
};

/// Fills the box with an area, crosses it with a line, or puts a mark into its middle. `text_pt`: height of the text
/// beside it.
Swatch swatch_of(const LegendRow& row, const Box<2>& box, double text_pt);

}  // namespace sightline
