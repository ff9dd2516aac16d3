// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/chart.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/error.h"
#include "core/base/excerpt.h"
#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/number.h"
#include "core/base/quote.h"
#include "core/base/text.h"
#include "core/process/run_program.h"
#include "lab/report/chart_key.h"
#include "lab/report/chart_labels.h"
#include "lab/report/chart_layout.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;

constexpr double mm = 96 / 25.4;  ///< in 1/96 inch
constexpr double pt = 96 / 72.0;

std::string style_of(const Series& s) {
    std::string text = std::string("with ") + (!has_markers(s) ? "lines" : has_line(s) ? "linespoints" : "points");
    const bool many = s.points.size() > 24;
    // A curve of many points that follow one another has a marker here and there.
    if (has_markers(s))
        text += " pt " + std::to_string(marker_number(s.look)) + " ps " + (many && s.sampled ? "0.5" : "0.8") +
                (has_line(s) && many && !s.sampled ? " pi " + std::to_string(s.points.size() / 12) : "");
    if (has_line(s)) text += " dt " + dash_text(s.look);
    return text + " lc rgb " + gnuplot_quoted(hex_colour(s.look.colour)) + " lw " + short_number(s.width);
}

bool fits(const Chart& chart, const std::array<double, 2>& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]) && (!chart.log_x || point[0] > 0) &&
           (!chart.log_y || point[1] > 0);
}

AxisRange range_of(const Chart& chart, int axis) {
    std::vector<double> values;
    const bool log = axis == 0 ? chart.log_x : chart.log_y;
    for (const Series& s : chart.series)
        for (std::size_t p = 0; p < s.points.size(); ++p) {
            if (!fits(chart, s.points[p])) continue;
            const double value = s.points[p][static_cast<std::size_t>(axis)];
            const double error = s.errors.empty() ? 0 : s.errors[p][static_cast<std::size_t>(axis)];
            values.push_back(value);
            if (std::isfinite(error)) values.push_back(value + error);
            if (std::isfinite(error) && (!log || value > error)) values.push_back(value - error);
        }
    return axis_range(values, log, axis == 1 && chart.is_share);
}

/// Where a value lies between the ends of its axis, 0 to 1.
double along(double value, const AxisRange& range, bool log) {
    return log ? std::log(value / range.from) / std::log(range.to / range.from)
               : (value - range.from) / (range.to - range.from);
}

/// 1, 2 and 5 of each power of ten, where gnuplot would name hardly any.
std::string log_tics(const AxisRange& range, const char* axis) {
    if (range.to > 300 * range.from) return {};
    std::string tics;
    for (double power = std::pow(10, std::floor(std::log10(range.from))); power <= range.to; power *= 10)
        for (const double digit : {1, 2, 5})
            if (digit * power >= range.from && digit * power <= range.to)
                tics += (tics.empty() ? "" : ",") + gnuplot_quoted(short_number(digit * power, 2)) + " " +
                        number_text(digit * power);
    return tics.empty() ? "" : "set " + std::string(axis) + "tics (" + tics + ")\n";
}

/// Labels as commands: strings among data are read by rules of their own.
std::string label_commands(const Chart& chart, const ChartFormat& format, const ChartLayout& layout,
                           const AxisRange& x_range, const AxisRange& y_range) {
    const double font = format.font, left = layout.left, below = layout.bottom, height = layout.height;
    const double wide = std::max(format.width - left - layout.right, 1.0),
                 high = std::max(height - below - layout.top, 1.0);
    std::vector<ChartLabel> labels;
    std::vector<std::array<double, 2>> points, lines, at;
    std::vector<Colour> colours;
    for (const Series& s : chart.series) {
        std::array<double, 2> before{};
        bool joined = false;
        for (std::size_t p = 0; p < s.points.size(); ++p) {
            if (!fits(chart, s.points[p])) {
                joined = false;
                continue;
            }
            const std::array<double, 2> pixel{left + wide * along(s.points[p][0], x_range, chart.log_x),
                                              below + high * along(s.points[p][1], y_range, chart.log_y)};
            if (has_markers(s)) points.push_back(pixel);
            if (joined && has_line(s)) {
                const auto [x, y] = before;
                const double steps = std::ceil(std::hypot(pixel[0] - x, pixel[1] - y) / (0.4 * font));
                for (double i = 1; i < steps; ++i)
                    lines.push_back({x + (pixel[0] - x) * i / steps, y + (pixel[1] - y) * i / steps});
            }
            before = pixel;
            joined = true;
            if (s.labels.empty() || s.labels[p].empty()) continue;
            labels.push_back({s.labels[p], pixel[0], pixel[1]});
            at.push_back(s.points[p]);
            colours.push_back(s.look.colour);
        }
    }
    const std::vector<LabelPlace> places = place_labels(labels, points, lines, 0.75 * font);
    std::string text;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const LabelPlace& place = places[i];
        if (place.shared) continue;
        text += "set label " + gnuplot_quoted(labels[i].text) + " noenhanced at " + number_text(at[i][0]) + "," +
                number_text(at[i][1]) +
                (place.side > 0   ? " left"
                 : place.side < 0 ? " right"
                                  : " center") +
                " offset screen " + short_number((place.x - labels[i].x) / format.width, 4) + "," +
                short_number((place.y - labels[i].y) / height, 4) + " font label_font tc rgb " +
                gnuplot_quoted(hex_colour(colours[i])) + " front\n";
    }
    return text;
}

std::string range_text(const AxisRange& range) {
    return "[" + number_text(range.from) + ":" + number_text(range.to) + "]";
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

ChartFormat read_chart_size(const std::string& text) {
    const auto refuse = [&]() -> ChartFormat {
        throw InputError("--chart-size '" + excerpt(text) +
                         "': write a width such as 84mm, 120x80mm, or pixels such "
                         "as 1200x600; from 40 to 1000 mm, from 200 to 10000 pixels");
    };
    const bool in_mm = text.ends_with("mm");
    const std::string_view numbers = std::string_view(text).substr(0, text.size() - (in_mm ? 2 : 0));
    const std::size_t by = numbers.find('x');
    const auto width = parse_number(numbers.substr(0, by));
    const auto height = by == std::string_view::npos ? std::nullopt : parse_number(numbers.substr(by + 1));
    if (!width || (by != std::string_view::npos && !height) || (!in_mm && !height)) return refuse();
    ChartFormat format;
    const double least = in_mm ? 40 : 200, most = in_mm ? 1000 : 10'000, unit = in_mm ? mm : 1;
    for (const double side : {*width, height.value_or(*width)})
        if (!(side >= least && side <= most)) return refuse();
    format.width = unit * *width;
    format.height = height ? unit * *height : 0.66 * format.width;
    if (in_mm) {
        format.font = 8 * pt;
        format.scale = 300 / 96.0;
    }
    return format;
}

AxisRange axis_range(const std::vector<double>& values, bool log, bool is_share) {
    if (values.empty()) return {log ? 0.1 : 0, 1};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (log) {
        const double margin = std::max(1.15, std::pow(*high / *low, 0.05));
        return {*low / margin, *high * margin};
    }
    const bool from_zero = *low >= 0 && *low <= 0.5 * *high;
    const double bottom = from_zero ? 0 : *low;
    double span = *high - bottom;
    if (span <= 0) span = *high != 0 ? 0.2 * std::abs(*high) : 1;
    AxisRange range{bottom - 0.04 * span, *high + 0.06 * span};
    if (is_share && *high <= 100) range.to = std::min(range.to, 100 + 0.03 * span);
    return range;
}

std::vector<Series> told_apart_in_grey(std::vector<Series> series) {
    static constexpr std::array dashed{6.0f, 3.0f}, dotted{1.5f, 2.5f}, long_dashed{14.0f, 4.0f};
    static constexpr std::array dash_dot{8.0f, 2.5f, 1.5f, 2.5f};
    static constexpr std::array<std::span<const float>, 4> dashes{dashed, long_dashed, dotted, dash_dot};
    const auto same = [](const Series& a, const Series& b) {
        return a.look.marker == b.look.marker && a.look.filled == b.look.filled && has_markers(a) == has_markers(b) &&
               std::equal(a.look.dash.begin(), a.look.dash.end(), b.look.dash.begin(), b.look.dash.end());
    };
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (!has_line(series[i]) || !has_markers(series[i])) continue;
        const auto is_taken = [&] {
            return std::any_of(series.begin(), series.begin() + static_cast<std::ptrdiff_t>(i),
                               [&](const Series& other) { return has_line(other) && same(other, series[i]); });
        };
        const auto own = series[i].look.dash;
        for (std::size_t d = 0; d < dashes.size() && is_taken(); ++d) series[i].look.dash = dashes[d];
        if (is_taken()) series[i].look.dash = own;
    }
    return series;
}

namespace {

/// What has no point to show has no name in the key.
Chart with_names_of_what_is_shown(Chart chart) {
    for (Series& s : chart.series)
        if (std::none_of(s.points.begin(), s.points.end(), [&](const auto& point) { return fits(chart, point); }))
            s.name.clear();
    return chart;
}

}  // namespace

double chart_height(const Chart& chart, const ChartFormat& format) {
    return layout_of(with_names_of_what_is_shown(chart), format, range_of(chart, 1)).height;
}

std::string gnuplot_script(const Chart& asked, const ChartFormat& format) {
    Chart chart = with_names_of_what_is_shown(asked);
    chart.series = told_apart_in_grey(std::move(chart.series));
    const AxisRange x_range = range_of(chart, 0), y_range = range_of(chart, 1);
    const ChartLayout at = layout_of(chart, format, y_range);
    const auto x = [&](double pixels) { return short_number(pixels / format.width, 5); };
    const auto y = [&](double pixels) { return short_number(pixels / at.height, 5); };
    std::string text = "set encoding utf8\n";
    if (format.titles) text += "set title " + lines_quoted(at.title) + " noenhanced\n";
    text += "set xlabel " + lines_quoted(at.x) + " noenhanced\nset ylabel " + lines_quoted(at.y) + " noenhanced\n" +
            "set lmargin at screen " + x(at.left) + "\nset rmargin at screen " + x(format.width - at.right) +
            "\nset tmargin at screen " + y(at.height - at.top) + "\nset bmargin at screen " + y(at.bottom) +
            "\nunset key\n" + key_commands(chart, format, at) +
            "set grid lc rgb \"#dddddd\" lt 1 lw 0.5\nset border 3 lc rgb \"#444444\"\nset tics nomirror\n"
            "set bars 0.6\n";
    if (chart.log_x) text += "set logscale x\n" + log_tics(x_range, "x");
    if (chart.log_y) text += "set logscale y\n" + log_tics(y_range, "y");
    std::string bars;
    std::string plots;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const Series& s = chart.series[i];
        const std::string name = "$s" + std::to_string(i);
        text += name + " << END\n";
        bool any = false, in_x = false, in_y = false;
        for (std::size_t p = 0; p < s.points.size(); ++p) {
            if (!fits(chart, s.points[p])) {
                text += "\n";
                continue;
            }
            any = true;
            std::array<double, 2> error{0, 0};
            if (!s.errors.empty())
                for (const std::size_t axis : {0u, 1u})
                    if (std::isfinite(s.errors[p][axis])) error[axis] = s.errors[p][axis];
            in_x |= error[0] > 0;
            in_y |= error[1] > 0;
            text += number_text(s.points[p][0]) + " " + number_text(s.points[p][1]);
            if (!s.errors.empty()) text += " " + number_text(error[0]) + " " + number_text(error[1]);
            text += "\n";
        }
        text += "END\n";
        if (!any) continue;
        const std::string next = ", \\\n     ";
        if (in_x || in_y)
            bars += (bars.empty() ? "" : next) + name + " using " +
                    (in_x && in_y ? "1:2:3:4 with xyerrorbars"
                     : in_x       ? "1:2:3 with xerrorbars"
                                  : "1:2:4 with yerrorbars") +
                    " pt 0 lw 0.7 lc rgb " + gnuplot_quoted(hex_colour(s.look.colour)) + " notitle";
        plots += (plots.empty() ? "" : next) + name + " using 1:2 " + style_of(s) + " notitle";
    }
    if (!bars.empty()) plots = bars + ", \\\n     " + plots;  // under the lines and their markers
    // gnuplot draws no empty chart: one with axes says that there is nothing.
    if (plots.empty())
        return text +
               "set label \"nothing to show\" at graph 0.5,0.5 center\nset xrange [0:1]\nset yrange [-2:1]\nunset "
               "logscale\nplot -1 notitle\n";
    return text + "set xrange " + range_text(x_range) + "\nset yrange " + range_text(y_range) + "\n" +
           label_commands(chart, format, at, x_range, y_range) + "plot " + plots + "\n";
}

namespace {

/// A folder of its own for gnuplot, which writes in place; gone with it.
class Workshop {
public:
    Workshop() {
        std::error_code error;
        fs::path parent = fs::temp_directory_path(error);
        if (error) parent = "/tmp";
        std::string name = (parent / "sightline-chart-XXXXXX").string();
        if (!mkdtemp(name.data())) throw WorkError("cannot make a folder in " + one_line(parent.string(), 1000));
        folder_ = name;
    }
    ~Workshop() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    const fs::path& folder() const { return folder_; }

private:
    fs::path folder_;
};

}  // namespace

void write_chart(const Chart& chart, const fs::path& stem, const ChartFormat& format) {
    // gnuplot knows programs to run by how the name of a file begins, and a folder can have any name.
    const std::string name = "./" + stem.filename().string();
    const double height = chart_height(chart, format);
    const std::string body = gnuplot_script(chart, format);
    const auto size = [&](double unit) {
        return short_number(format.width * unit, 5) + (unit < 0.1 ? "in," : ",") + short_number(height * unit, 5) +
               (unit < 0.1 ? "in" : "");
    };
    // Letters of the SVG are in pixels; those of the others are in points of their own.
    const auto terminal = [&](const std::string& kind, const std::string& ending, double font) {
        return "set terminal " + kind + " font \"DejaVu Sans," + short_number(font) +
               "\" background rgb \"white\"\nset output " + gnuplot_quoted(name + ending) + "\nlabel_font = \"," +
               short_number(0.75 * font) + "\"\n" + body + "unset output\n";
    };
    const auto pixels = [&](double side) { return std::to_string(std::lround(side * format.scale)); };
    const std::string s = short_number(format.scale, 5);
    const std::string script = terminal("svg enhanced rounded size " + size(1), ".svg", format.font) + "reset\n" +
                               terminal("pdfcairo enhanced rounded size " + size(1 / 96.0), ".pdf", format.font / pt) +
                               "reset\n" +
                               terminal("pngcairo enhanced rounded size " + pixels(format.width) + "," +
                                            pixels(height) + " fontscale " + s + " linewidth " + s + " pointscale " + s,
                                        ".png", format.font / pt);
    const Workshop workshop;
    const fs::path file = workshop.folder() / stem.filename();
    const auto with = [](fs::path path, const char* ending) { return path += ending; };
    write_file(with(file, ".gp"), script);
    run_program({"gnuplot", "-d", name + ".gp"}, "gnuplot-nox", workshop.folder());
    for (const char* const ending : {".gp", ".svg", ".pdf", ".png"})
        write_file(with(stem, ending), read_file(with(file, ending)));
}

}  // namespace sightline::lab
