// The options of commands that draw charts.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include "lab/report/chart.h"

namespace sightline::lab {

/// --chart-size and --no-titles; `format` outlives the parsing.
inline void add_chart_options(CLI::App& app, ChartFormat& format) {
    app.add_option_function<std::string>(
           "--chart-size",
           [&format](const std::string& text) {
               const bool titles = format.titles;
               format = read_chart_size(text);
               format.titles = titles;
           },
           "of the charts: a width such as 84mm, 120x80mm, or pixels such as 1200x600; default: 860x460")
        ->type_name("SIZE");
    app.add_flag_function(
        "--no-titles", [&format](std::int64_t) { format.titles = false; },
        "charts have no title, for figures with a caption");
}

}  // namespace sightline::lab
