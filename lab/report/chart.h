// Charts as plain data; gnuplot draws them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/draw/variant_look.h"

namespace sightline::lab {

struct Series {
    std::string name;  ///< in the key; empty: not there
    VariantLook look{};
    enum class Shown { line_and_markers, line, markers } shown = Shown::line_and_markers;
    double width = 2;
    std::vector<std::array<double, 2>> points;  ///< not finite: a gap
    std::vector<std::string> labels;            ///< beside the points; none, or one per point
};

struct Chart {
    std::string title, x, y;
    bool log_x = false, log_y = false;
    bool from_zero = true;  ///< the y axis, where it is linear
    double most_y = 0;      ///< where the y axis ends; 0: where the data do
    std::vector<Series> series;
};

/// For gnuplot 5.4, with the data in it; what stands before it chooses terminal and output.
std::string gnuplot_script(const Chart& chart);

/// stem.gp, stem.svg and stem.png; the script, run by gnuplot in its folder, makes the others again. The last part of
/// `stem` is a file_stem(). Throws WorkError when gnuplot is not there or fails.
void write_chart(const Chart& chart, const std::filesystem::path& stem);

/// `text` as the name of a file without a folder: letters, digits, '-', '.' and '_', not too many for an ending.
std::string file_stem(std::string text);

}  // namespace sightline::lab
