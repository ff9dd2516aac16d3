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
    std::vector<std::array<double, 2>> points;    ///< not finite: a gap
    std::vector<std::string> labels{};            ///< beside the points; none, or one per point
    std::vector<std::array<double, 2>> errors{};  ///< ± in x and y; none, or one per point; NaN: no bar
    bool sampled = false;  ///< between the points nothing was measured: each has its marker, however many there are
};

struct Chart {
    std::string title, x, y;
    bool log_x = false, log_y = false;
    bool is_share = false;  ///< y is per cent of something: its axis ends a little beyond 100
    std::vector<Series> series;
};

/// How charts are put down.
struct ChartFormat {
    double width = 860, height = 460;  ///< in 1/96 inch, pixels of the SVG
    double font = 11;                  ///< its size in the same
    double scale = 1;                  ///< of the PNG
    bool titles = true;
};

/// "84mm" or "120x80mm", with letters of 8 points and PNGs at 300 dpi; "1200x600": pixels. Throws InputError.
ChartFormat read_chart_size(const std::string& text);

/// Where an axis begins and ends: around all values with a margin, so that none lies on the border, and from 0 where
/// that takes up less than half of it. `log`: values are positive.
struct AxisRange {
    double from, to;
};
AxisRange axis_range(const std::vector<double>& values, bool log, bool is_share = false);

/// The series with dashes where two would look alike in grey, by marker and line; those of look stay where they can.
std::vector<Series> told_apart_in_grey(std::vector<Series> series);

/// For gnuplot 5.4, with the data in it; what stands before it chooses terminal and output and sets label_font.
std::string gnuplot_script(const Chart& chart, const ChartFormat& format = {});
/// What the format says, and what the key needs under a chart that is too narrow to have it at its side.
double chart_height(const Chart& chart, const ChartFormat& format);

/// stem.gp, stem.svg, stem.pdf and stem.png; the script, run by gnuplot in its folder, makes the others again. The last
/// part of `stem` is a file_stem(). Each file appears whole or not at all. Throws WorkError when gnuplot is not there
/// or fails.
void write_chart(const Chart& chart, const std::filesystem::path& stem, const ChartFormat& format = {});

/// `text` as the name of a file without a folder: letters, digits, '-', '.' and '_', not too many for an ending.
std::string file_stem(std::string text);

}  // namespace sightline::lab
