// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/flight_path_csv.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/base/utf8_mark.h"
#include "core/scene/clean.h"

namespace sightline {

namespace {

/// Of the numbers of a frame: eye, look_at, fov.
template <int D>
constexpr std::size_t column_count = 2 * D + 1;

template <int D>
std::array<std::string, column_count<D>> column_names() {
    std::array<std::string, column_count<D>> names;
    for (std::size_t i = 0; i < D; ++i) {
        names[i] = std::string("eye_") + "xyz"[i];
        names[D + i] = std::string("look_at_") + "xyz"[i];
    }
    names[2 * D] = "fov";
    return names;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t\r\"");
    if (from == std::string_view::npos) return {};
    return text.substr(from, text.find_last_not_of(" \t\r\"") + 1 - from);
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (;;) {
        const std::size_t comma = line.find(',');
        fields.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) return fields;
        line.remove_prefix(comma + 1);
    }
}

}  // namespace

template <int D>
FlightPath<D> read_csv_path(std::string_view text, const std::string& name) {
    text = without_mark(text);
    const auto names = column_names<D>();
    std::array<std::size_t, column_count<D>> place{};
    std::size_t columns = 0;
    FlightPath<D> path;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
        const std::string at = "line " + std::to_string(number);
        const std::vector<std::string_view> fields = fields_of(line);
        if (columns == 0) {
            columns = fields.size();
            for (std::size_t i = 0; i < names.size(); ++i) {
                const auto found = std::find(fields.begin(), fields.end(), names[i]);
                place[i] = static_cast<std::size_t>(found - fields.begin());
                if (found == fields.end() && names[i] != "fov")
                    throw input_error(name, at,
                                      "no column " + names[i] +
                                          ": a path is JSON, or CSV with a first line "
                                          "such as " +
                                          csv_path_columns<D>());
                if (std::count(fields.begin(), fields.end(), names[i]) > 1)
                    throw input_error(name, at, "column " + names[i] + " is there twice");
            }
            continue;
        }
        if (fields.size() != columns)
            throw input_error(name, at,
                              std::to_string(fields.size()) + " columns, " + std::to_string(columns) + " expected");
        ViewSpec<D> frame;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (place[i] >= columns) continue;  // fov
            const std::optional<double> value = parse_number(fields[place[i]]);
            if (!value)
                throw input_error(name, at, names[i] + " \"" + one_line(fields[place[i]], 40) + "\" is not a number");
            (i < D       ? frame.eye[static_cast<int>(i)]
             : i < 2 * D ? frame.look_at[static_cast<int>(i - D)]
                         : frame.fov) = *value;
        }
        check_view(frame, name, at);
        path.frames.push_back(frame);
    }
    if (path.frames.empty()) throw input_error(name, "", "a path needs one frame at least");
    return path;
}

template <int D>
std::string csv_path_columns() {
    std::string line;
    for (const std::string& column : column_names<D>()) line += (line.empty() ? "" : ",") + column;
    return line;
}

template <int D>
std::string write_csv_path(const FlightPath<D>& path) {
    std::string out = csv_path_columns<D>() + "\n";
    for (const ViewSpec<D>& frame : path.frames) {
        for (const Vec<D>& point : {frame.eye + path.origin, frame.look_at + path.origin})
            for (int i = 0; i < D; ++i) out += number_text(point[i]) + ",";
        out += number_text(frame.fov) + "\n";
    }
    return out;
}

template FlightPath<2> read_csv_path<2>(std::string_view, const std::string&);
template FlightPath<3> read_csv_path<3>(std::string_view, const std::string&);
template std::string csv_path_columns<2>();
template std::string csv_path_columns<3>();
template std::string write_csv_path<2>(const FlightPath<2>&);
template std::string write_csv_path<3>(const FlightPath<3>&);

}  // namespace sightline
