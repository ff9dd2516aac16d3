// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/chart.h"

#include <cctype>
#include <cmath>

#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/process/run_program.h"

namespace sightline::lab {

namespace {

/// gnuplot's number of a marker: open ones are even, the filled one of the same shape is the next.
int number_of(const VariantLook& look) {
    static constexpr std::array<int, marker_count> open{6, 4, 8, 12, 10, 14};
    return open[static_cast<std::size_t>(look.marker)] + (look.filled ? 1 : 0);
}

std::string style_of(const Series& s) {
    const bool line = s.shown != Series::Shown::markers, markers = s.shown != Series::Shown::line;
    std::string text = std::string("with ") + (!markers ? "lines" : line ? "linespoints" : "points");
    // A curve of many points has a marker here and there.
    if (markers)
        text += " pt " + std::to_string(number_of(s.look)) + " ps 0.8" +
                (line && s.points.size() > 24 ? " pi " + std::to_string(s.points.size() / 12) : "");
    if (line) {
        constexpr double gnuplots_unit = 0.5;  // of a dash, in widths of the line
        std::string lengths;
        for (const float length : s.look.dash)
            lengths += (lengths.empty() ? "" : ",") + short_number(length / gnuplots_unit);
        text += " dt " + (lengths.empty() ? "1" : "(" + lengths + ")");
    }
    return text + " lc rgb " + gnuplot_quoted(hex_colour(s.look.colour)) + " lw " + short_number(s.width);
}

}  // namespace

std::string file_stem(std::string text) {
    constexpr std::size_t most = 200;  // file systems end at 255 bytes
    if (text.size() > most) {
        Hash hash;
        for (const char c : text) hash.add(c);
        text = text.substr(0, most - 17) + "-" + hash_text(hash.value());
    }
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    return text;
}

std::string gnuplot_script(const Chart& chart) {
    std::string text = "set encoding utf8\nset title " + gnuplot_quoted(chart.title) + " noenhanced\nset xlabel " +
                       gnuplot_quoted(chart.x) + " noenhanced\nset ylabel " + gnuplot_quoted(chart.y) +
                       " noenhanced\n"
                       "set key outside right top noenhanced spacing 1.2\nset grid lc rgb \"#dddddd\" lt 1 lw 0.5\n"
                       "set border 3 lc rgb \"#444444\"\nset tics nomirror\n";
    if (chart.log_x) text += "set logscale x\n";
    if (chart.log_y) text += "set logscale y\n";
    const std::string most = chart.most_y > 0 ? short_number(chart.most_y, 6) : "*";
    if (!chart.log_y && (chart.from_zero || chart.most_y > 0))
        text += "set yrange [" + std::string(chart.from_zero ? "0" : "*") + ":" + most + "]\n";
    std::string plots, labels;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const Series& s = chart.series[i];
        const std::string name = "$s" + std::to_string(i);
        text += name + " << END\n";
        bool any = false;
        for (std::size_t p = 0; p < s.points.size(); ++p) {
            const auto& [x, y] = s.points[p];
            const bool fits =
                std::isfinite(x) && std::isfinite(y) && (!chart.log_x || x > 0) && (!chart.log_y || y > 0);
            any |= fits;
            text += fits ? number_text(x) + " " + number_text(y) + "\n" : "\n";
            // As commands: strings among data are read by rules of their own.
            if (fits && !s.labels.empty() && !s.labels[p].empty())
                labels += "set label " + gnuplot_quoted(s.labels[p]) + " noenhanced at " + number_text(x) + "," +
                          number_text(y) + " left offset 0.4,0.6 font ',8' tc rgb " +
                          gnuplot_quoted(hex_colour(s.look.colour)) + " front\n";
        }
        text += "END\n";
        if (!any) continue;
        plots += (plots.empty() ? "plot " : ", \\\n     ") + name + " using 1:2 " + style_of(s) +
                 (s.name.empty() ? " notitle" : " title " + gnuplot_quoted(s.name));
    }
    // gnuplot draws no empty chart: one with axes says that there is nothing.
    if (plots.empty())
        plots =
            "set label \"nothing to show\" at graph 0.5,0.5 center\nset xrange [0:1]\nset yrange [-2:1]\nunset "
            "logscale\nplot -1 notitle";
    return text + labels + plots + "\n";
}

void write_chart(const Chart& chart, const std::filesystem::path& stem) {
    // gnuplot knows programs to run by how the name of a file begins, and a folder can have any name.
    const std::string name = "./" + stem.filename().string(), body = gnuplot_script(chart);
    const auto terminal = [&](const std::string& kind, const std::string& ending) {
        return "set terminal " + kind + " size 860,460 font \"DejaVu Sans,11\" background rgb \"white\"\nset output " +
               gnuplot_quoted(name + ending) + "\n" + body + "unset output\n";
    };
    std::filesystem::path script = stem;
    script += ".gp";
    write_file(script, terminal("svg enhanced rounded", ".svg") + "reset\n" + terminal("pngcairo", ".png"));
    run_program({"gnuplot", "-d", name + ".gp"}, "gnuplot-nox", stem.has_parent_path() ? stem.parent_path() : ".");
}

}  // namespace sightline::lab
