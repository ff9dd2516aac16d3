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

std::string fit_text(const Calibration& fitted, const std::vector<Variant<3>>& options) {
    return "  " + parameters_text(fitted, options) + "\n    r² " + short_number(fitted.r2) + " of frames, " +
           short_number(fitted.r2_draw) + " of drawing alone\n";
}

std::string chosen_text(const ViewpointScene& scene) {
    const ViewpointTable<3>& table = *scene.table;
    std::vector<std::size_t> counts(scene.options().size());
    for (std::size_t place = 0; place < table.size(); ++place)
        if (const Entry* entry = table.find(place)) ++counts[entry->chosen];
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i)
        text += (i ? ", " : "") + scene.options()[i].text + " " + std::to_string(counts[i]);
    return text;
}

std::string share_of_scene(const ViewpointScene& scene, std::size_t bytes) {
    return short_number(100.0 * static_cast<double>(bytes) / static_cast<double>(scene.scene_bytes)) +
           " % of the scene's primitives";
}

std::string merged_text(const MergedSize& merged) {
    return std::to_string(merged.merged_regions) + " of " + std::to_string(merged.regions) + " regions, " +
           std::to_string(merged.merged_entries) + " of " + std::to_string(merged.entries) + " entries";
}

std::string table_text(const ViewpointScene& scene) {
    const ViewpointTable<3>& table = *scene.table;
    const TableFill& fill = scene.fill;
    std::string text = "table: " + counted(table.regions().count(), "region") + " × " +
                       counted(table.directions().count(), "interval") + ", " + std::to_string(table.known()) + " of " +
                       std::to_string(table.size()) + " entries known; " + chosen_text(scene) + "\n";
    if (fill.seconds > 0)
        text += "  worked out in " + short_number(fill.seconds) + " s (" + std::to_string(fill.known_before) +
                " were known); merged: " + merged_text(fill.merged) + " are left\n";
    if (fill.file_bytes > 0)
        text += "  file: " + counted(fill.file_bytes, "byte") + ", " + share_of_scene(scene, fill.file_bytes) + "\n";
    for (const TableSize& size : scene.sizes)
        text += "  " + std::to_string(size.azimuths) + " × " + std::to_string(size.elevations) +
                " and two caps: " + counted(size.file_bytes, "byte") + ", " + share_of_scene(scene, size.file_bytes) +
                ", " + short_number(size.seconds) + " s; merged: " + merged_text(size.merged) + "\n";
    return text;
}

std::string technique_text(const ViewpointScene& scene, std::size_t i) {
    const ViewpointWalk& walk = scene.walk;
    double wrong = 0;
    for (const WalkFrame& frame : walk.frames) wrong += frame.alone[i].wrong / static_cast<double>(walk.frames.size());
    return "  " + scene.options()[i].text + ": mean " + ms_text(walk.alone_ms(i)) + ", worst " +
           ms_text(walk.worst_alone_ms(i)) + ", wrong pixels " + short_number(100 * wrong) + " %; " +
           inequality_text(walk, i) + "\n";
}

std::string scene_text(const ViewpointScene& scene) {
    const ViewpointWalk& walk = scene.walk;
    std::string text =
        scene.scene + ", path " + scene.path + ", " + counted(walk.frames.size(), "frame") + "\n" + scene.method + "\n";
    if (!scene.fits.empty()) text += "cost model, fitted, in both readings:\n";
    for (const Calibration& fitted : scene.fits) text += fit_text(fitted, scene.options());
    text += table_text(scene);
    text += "look-up: " + short_number(walk.look_up_ns) +
            " ns; an empty frame, left out below: " + ms_text(walk.empty_ms) + "\n";
    for (std::size_t i = 0; i < scene.options().size(); ++i) text += technique_text(scene, i);
    const std::size_t best = walk.best_alone();
    text += "  by viewpoint: mean " + ms_text(walk.adaptive_ms()) + ", worst " + ms_text(walk.worst_adaptive_ms()) +
            "; changes " + std::to_string(walk.switches) + " times\n";
    text += "  of the best one in each frame, with hindsight (" + ms_text(walk.hindsight_ms()) +
            "): " + short_number(walk.adaptive_ms() / walk.hindsight_ms()) + " times; of the best single one (" +
            scene.options()[best].text + "): " + short_number(walk.adaptive_ms() / walk.alone_ms(best)) +
            " times, the worst frame " + short_number(walk.worst_adaptive_ms() / walk.worst_alone_ms(best)) +
            " times\n";
    return text + "  predicted by entries against measured in frames: r² " + short_number(walk.r2()) + "\n";
}

Series series_named(const std::string& name, const VariantLook& look) {
    Series series;
    series.name = name;
    series.look = look;
    return series;
}

std::string csv_quoted(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string time_cells(const FrameTime& time) {
    return "," + number_text(time.cull_ms) + "," + number_text(time.draw_ms) + "," + std::to_string(time.drawn) + "," +
           number_text(time.wrong);
}

std::string frames_csv(const ViewpointScene& scene) {
    const ViewpointTable<3>& table = *scene.table;
    std::string csv = "frame,where,region,interval,technique,entry,predicted_ms,best_ms,everything_ms";
    const auto add_head = [&](const std::string& name) {
        for (const char* const what : {" cull_ms", " draw_ms", " drawn", " wrong"})
            csv += "," + csv_quoted(name + what);
    };
    add_head("by viewpoint");
    for (const Variant<3>& option : scene.options()) add_head(option.text);
    csv += "\n";
    for (std::size_t k = 0; k < scene.walk.frames.size(); ++k) {
        const WalkFrame& frame = scene.walk.frames[k];
        csv += std::to_string(scene.frames[k]) + "," +
               std::string(eye_place_words[static_cast<std::size_t>(frame.where)]) + "," +
               std::to_string(table.region_of(frame.place)) + "," + std::to_string(table.interval_of(frame.place)) +
               "," + csv_quoted(scene.options()[frame.technique].text) + "," +
               csv_quoted(scene.options()[frame.entry].text) + "," + number_text(frame.predicted_ms) + "," +
               number_text(frame.best_ms()) + "," + number_text(frame.everything.draw_ms) + time_cells(frame.adaptive);
        for (const FrameTime& time : frame.alone) csv += time_cells(time);
        csv += "\n";
    }
    return csv;
}

}  // namespace

const Calibration& ViewpointScene::best_fit() const {
    return *std::max_element(fits.begin(), fits.end(),
                             [](const Calibration& a, const Calibration& b) { return a.r2 < b.r2; });
}

std::string inequality_text(const ViewpointWalk& walk, std::size_t technique) {
    const double select_ms = 1e-6 * walk.look_up_ns;
    const double valid = static_cast<double>(walk.frames.size()) / static_cast<double>(walk.switches + 1);
    const double left = select_ms / valid + walk.adaptive_ms(), right = walk.alone_ms(technique);
    return short_number(select_ms) + " / " + short_number(valid) + " + " + short_number(walk.adaptive_ms()) +
           (left < right ? " < " : " ≥ ") + short_number(right);
}

Chart walk_chart(const ViewpointScene& scene) {
    Chart chart;
    chart.title = scene.scene + ", " + scene.path + ": time of each frame";
    chart.x = "frame of the path";
    chart.y = "culling, upload and drawing, ms";
    chart.log_y = true;
    std::vector<MethodChoice> methods;
    for (const Variant<3>& option : scene.options()) methods.push_back({option.text, Tessellation::delaunay});
    const MethodLooks looks(methods);
    Series adaptive = series_named("by viewpoint", {{0, 0, 0}, {}});
    adaptive.width = 4;
    adaptive.shown = Series::Shown::line;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        Series series = series_named(methods[i].variant, looks.look(methods[i]));
        for (std::size_t k = 0; k < scene.walk.frames.size(); ++k)
            series.points.push_back({static_cast<double>(scene.frames[k]), scene.walk.frames[k].alone[i].ms()});
        chart.series.push_back(std::move(series));
    }
    for (std::size_t k = 0; k < scene.walk.frames.size(); ++k)
        adaptive.points.push_back({static_cast<double>(scene.frames[k]), scene.walk.frames[k].adaptive.ms()});
    chart.series.push_back(std::move(adaptive));
    return chart;
}

Chart table_sizes_chart(const ViewpointScene& scene) {
    Chart chart;
    chart.title = scene.scene + ": memory of the table";
    chart.x = "intervals of directions";
    chart.y = "KiB";
    chart.log_x = chart.log_y = true;
    Series whole = series_named("as a file", {{0, 0, 0}, {}}), merged = series_named("equal neighbours merged", {});
    merged.look = {{30, 110, 200}, {}};
    for (const TableSize& size : scene.sizes) {
        const double x = static_cast<double>(size.intervals), kib = static_cast<double>(size.file_bytes) / 1024;
        whole.points.push_back({x, kib});
        merged.points.push_back(
            {x, kib * static_cast<double>(size.merged.merged_entries) / static_cast<double>(size.merged.entries)});
    }
    chart.series = {std::move(whole), std::move(merged)};
    return chart;
}

std::string viewpoint_text(const ViewpointResults& results) {
    std::string text = results.conditions.machine + "; " + results.conditions.renderer + "; " +
                       image_size_text(results.image) + ", " + counted(std::size_t(results.repeats), "repeat") + "\n";
    for (const ViewpointScene& scene : results.scenes) text += "\n" + scene_text(scene);
    text += "\n";
    for (const Claim& claim : viewpoint_claims(results)) {
        text += verdict_text(claim) + ": " + claim.text + " (" + claim.source + "; " + claim.test + ")\n";
        for (const Regime& regime : claim.regimes) text += "  " + regime_text(claim, regime) + "\n";
    }
    return text;
}

void write_viewpoint(const ViewpointResults& results, const std::filesystem::path& folder, const ChartFormat& format) {
    std::filesystem::create_directories(folder);
    write_file(folder / "viewpoint.txt", viewpoint_text(results));
    for (const ViewpointScene& scene : results.scenes) {
        const std::string stem = file_stem(scene.scene + "-" + scene.path);
        write_file(folder / (stem + ".csv"), frames_csv(scene));
        write_chart(walk_chart(scene), folder / (stem + "-frames"), format);
        if (!scene.sizes.empty()) write_chart(table_sizes_chart(scene), folder / (stem + "-sizes"), format);
    }
}

}  // namespace sightline::lab
