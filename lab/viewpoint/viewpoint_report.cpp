// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/viewpoint/viewpoint_report.h"

#include <algorithm>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "lab/report/method_looks.h"

namespace sightline::lab {

namespace {

std::string ms_text(double ms) { return short_number(ms) + " ms"; }

const std::vector<Variant<3>>& options_of(const ViewpointResults& results) { return results.table->problem().options; }

std::string fit_text(const Calibration& fitted, const std::vector<Variant<3>>& options) {
    return "  " + parameters_text(fitted, options) + "\n    r² " + short_number(fitted.r2) + " of frames, " +
           short_number(fitted.r2_draw) + " of drawing alone\n";
}

std::string chosen_text(const ViewpointResults& results) {
    const ViewpointTable<3>& table = *results.table;
    std::vector<std::size_t> counts(options_of(results).size());
    for (std::size_t place = 0; place < table.size(); ++place)
        if (const Entry* entry = table.find(place)) ++counts[entry->chosen];
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i)
        text += (i ? ", " : "") + options_of(results)[i].text + " " + std::to_string(counts[i]);
    return text;
}

std::string table_text(const ViewpointResults& results) {
    const ViewpointTable<3>& table = *results.table;
    const TableFill& fill = results.fill;
    std::string text = "table: " + counted(table.regions().count(), "region") + " × " +
                       counted(table.directions().count(), "interval") + ", " + std::to_string(table.known()) + " of " +
                       std::to_string(table.size()) + " entries known; " + chosen_text(results) + "\n";
    if (fill.seconds > 0)
        text += "  worked out in " + short_number(fill.seconds) + " s (" + std::to_string(fill.known_before) +
                " were known); merged: " + std::to_string(fill.merged.merged_regions) + " of " +
                std::to_string(fill.merged.regions) + " regions, " + std::to_string(fill.merged.merged_entries) +
                " of " + std::to_string(fill.merged.entries) + " entries are left\n";
    if (fill.file_bytes > 0)
        text += "  file: " + counted(fill.file_bytes, "byte") + ", " +
                short_number(100.0 * static_cast<double>(fill.file_bytes) / static_cast<double>(results.scene_bytes)) +
                " % of the scene's primitives\n";
    return text;
}

/// t_select / valid_frames + t(α) against t(β) of each technique, as measured over the path.
std::string inequality_text(const ViewpointResults& results, std::size_t technique) {
    const ViewpointWalk& walk = results.walk;
    const double select_ms = 1e-6 * walk.look_up_ns;
    const double valid = static_cast<double>(walk.frames.size()) / static_cast<double>(walk.switches + 1);
    const double left = select_ms / valid + walk.adaptive_ms(), right = walk.alone_ms(technique);
    return short_number(select_ms) + " / " + short_number(valid) + " + " + short_number(walk.adaptive_ms()) +
           (left < right ? " < " : " ≥ ") + short_number(right);
}

Series series_named(const std::string& name, const VariantLook& look) {
    Series series;
    series.name = name;
    series.look = look;
    return series;
}

Chart frames_chart(const ViewpointResults& results) {
    Chart chart;
    chart.title = results.scene + ", " + results.path + ": time of each frame";
    chart.x = "frame of the path";
    chart.y = "culling, upload and drawing, ms";
    chart.log_y = true;
    std::vector<MethodChoice> methods;
    for (const Variant<3>& option : options_of(results)) methods.push_back({option.text, Tessellation::delaunay});
    const MethodLooks looks(methods);
    Series adaptive = series_named("by viewpoint", {{0, 0, 0}, {}});
    adaptive.width = 4;
    adaptive.shown = Series::Shown::line;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        Series series = series_named(methods[i].variant, looks.look(methods[i]));
        for (std::size_t k = 0; k < results.walk.frames.size(); ++k)
            series.points.push_back({static_cast<double>(results.frames[k]), results.walk.frames[k].alone[i].ms()});
        chart.series.push_back(std::move(series));
    }
    for (std::size_t k = 0; k < results.walk.frames.size(); ++k)
        adaptive.points.push_back({static_cast<double>(results.frames[k]), results.walk.frames[k].adaptive.ms()});
    chart.series.push_back(std::move(adaptive));
    return chart;
}

std::string csv_quoted(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string frames_csv(const ViewpointResults& results) {
    std::string csv =
        "frame,region,interval,technique,entry,predicted_ms,adaptive_cull_ms,adaptive_draw_ms,drawn,best_ms";
    for (const Variant<3>& option : options_of(results))
        csv += "," + csv_quoted(option.text + " cull_ms") + "," + csv_quoted(option.text + " draw_ms");
    csv += "\n";
    for (std::size_t k = 0; k < results.walk.frames.size(); ++k) {
        const WalkFrame& frame = results.walk.frames[k];
        csv += std::to_string(results.frames[k]) + "," + std::to_string(results.table->region_of(frame.place)) + "," +
               std::to_string(results.table->interval_of(frame.place)) + "," +
               csv_quoted(options_of(results)[frame.technique].text) + "," +
               csv_quoted(options_of(results)[frame.entry].text) + "," + number_text(frame.predicted_ms) + "," +
               number_text(frame.adaptive.cull_ms) + "," + number_text(frame.adaptive.draw_ms) + "," +
               std::to_string(frame.adaptive.drawn) + "," + number_text(frame.best_ms());
        for (const FrameTime& time : frame.alone)
            csv += "," + number_text(time.cull_ms) + "," + number_text(time.draw_ms);
        csv += "\n";
    }
    return csv;
}

}  // namespace

const Calibration& ViewpointResults::best_fit() const {
    return *std::max_element(fits.begin(), fits.end(),
                             [](const Calibration& a, const Calibration& b) { return a.r2 < b.r2; });
}

std::string viewpoint_text(const ViewpointResults& results) {
    const ViewpointWalk& walk = results.walk;
    std::string text = results.scene + ", path " + results.path + ", " + counted(walk.frames.size(), "frame") + "; " +
                       results.conditions.machine + "; " + results.conditions.renderer + "\n" + results.method + "\n";
    if (!results.fits.empty()) text += "cost model, fitted, in both readings:\n";
    for (const Calibration& fitted : results.fits) text += fit_text(fitted, options_of(results));
    text += table_text(results);
    text += "look-up: " + short_number(walk.look_up_ns) +
            " ns; an empty frame, left out below: " + ms_text(walk.empty_ms) + "\n";
    const std::size_t best = walk.best_alone();
    for (std::size_t i = 0; i < options_of(results).size(); ++i)
        text += "  " + options_of(results)[i].text + ": mean " + ms_text(walk.alone_ms(i)) + ", worst " +
                ms_text(walk.worst_alone_ms(i)) + "; " + inequality_text(results, i) + "\n";
    text += "  by viewpoint: mean " + ms_text(walk.adaptive_ms()) + ", worst " + ms_text(walk.worst_adaptive_ms()) +
            "; changes " + std::to_string(walk.switches) + " times\n";
    text += "  of the best one in each frame, with hindsight (" + ms_text(walk.hindsight_ms()) +
            "): " + short_number(walk.adaptive_ms() / walk.hindsight_ms()) + " times; of the best single one (" +
            options_of(results)[best].text + "): " + short_number(walk.adaptive_ms() / walk.alone_ms(best)) +
            " times, the worst frame " + short_number(walk.worst_adaptive_ms() / walk.worst_alone_ms(best)) +
            " times\n";
    std::vector<double> predicted, measured;
    for (const WalkFrame& frame : walk.frames) {
        predicted.push_back(frame.predicted_ms);
        measured.push_back(frame.adaptive.ms());
    }
    text +=
        "  predicted by entries against measured in frames: r² " + short_number(r_squared(predicted, measured)) + "\n";
    return text;
}

void write_viewpoint(const ViewpointResults& results, const std::filesystem::path& folder, const ChartFormat& format) {
    std::filesystem::create_directories(folder);
    write_file(folder / "viewpoint.csv", frames_csv(results));
    write_file(folder / "viewpoint.txt", viewpoint_text(results));
    write_chart(frames_chart(results), folder / "frames", format);
}

}  // namespace sightline::lab
