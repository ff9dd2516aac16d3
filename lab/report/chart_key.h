// The key of a chart, drawn by us: gnuplot's own leaves out names for which it finds no room.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "lab/report/chart_layout.h"

namespace sightline::lab {

inline bool has_line(const Series& s) { return s.shown != Series::Shown::markers; }
inline bool has_markers(const Series& s) { return s.shown != Series::Shown::line; }

/// gnuplot's number of a marker, and its type of a line: "1", or "(12,6)".
int marker_number(const VariantLook& look);
std::string dash_text(const VariantLook& look);

/// A piece of line with its marker, and the name, for each series that has one, where the layout has the key.
std::string key_commands(const Chart& chart, const ChartFormat& format, const ChartLayout& layout);

}  // namespace sightline::lab
