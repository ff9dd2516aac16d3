// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/chart_key.h"

#include "core/base/number.h"
#include "core/base/quote.h"

namespace sightline::lab {

int marker_number(const VariantLook& look) {
    // Open ones are even, the filled one of the same shape is the next.
    static constexpr std::array<int, marker_count> open{6, 4, 8, 12, 10, 14};
    return open[static_cast<std::size_t>(look.marker)] + (look.filled ? 1 : 0);
}

std::string dash_text(const VariantLook& look) {
    constexpr double gnuplots_unit = 0.5;  // of a dash, in widths of the line
    std::string lengths;
    for (const float length : look.dash) lengths += (lengths.empty() ? "" : ",") + short_number(length / gnuplots_unit);
    return lengths.empty() ? "1" : "(" + lengths + ")";
}

std::string key_commands(const Chart& chart, const ChartFormat& format, const ChartLayout& layout) {
    const double f = format.font;
    std::string text;
    std::size_t entry = 0;
    for (const Series& s : chart.series) {
        if (s.name.empty()) continue;
        const KeyEntry& place = layout.key[entry++];
        const auto at = [&](double x) {
            return " screen " + short_number((place.x + x) / format.width, 5) + "," +
                   short_number(place.y / layout.height, 5);
        };
        const std::string colour = " lc rgb " + gnuplot_quoted(hex_colour(s.look.colour));
        if (has_line(s))
            text += "set arrow from" + at(0) + " to" + at(3 * f) + " nohead dt " + dash_text(s.look) + " lw " +
                    short_number(s.width) + colour + " front\n";
        if (has_markers(s))
            text += "set label \"\" at" + at(1.5 * f) + " point pt " + std::to_string(marker_number(s.look)) +
                    " ps 0.8" + colour + " front\n";
        text += "set label " + lines_quoted(place.lines) + " at" + at(3.8 * f) + " left noenhanced front\n";
    }
    return text;
}

}  // namespace sightline::lab
