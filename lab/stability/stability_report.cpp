// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/stability/stability_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "lab/report/method_looks.h"
#include "lab/report/page.h"
#include "lab/stability/stability_charts.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

std::string_view disturbance_word(const StabilityRow& row) {
    return disturbance_words[static_cast<std::size_t>(row.disturbance)];
}
Json rows_json(const std::vector<StabilityRow>& rows) {
    Json all = Json::array();
    for (const StabilityRow& row : rows)
        all.push_back({{"scene", row.scene},
                       {"path", row.path},
                       {"method", row.method.variant},
                       {"tessellation", tessellation_word(row.method)},
                       {"budget", row.budget},
                       {"disturbance", disturbance_word(row)},
                       {"amount", row.amount},
                       {"samples", row.samples},
                       {"jaccard", row.jaccard},
                       {"jaccard_min", row.jaccard_min},
                       {"visible_jaccard", row.visible_jaccard},
                       {"coverage_change", row.coverage_change},
                       {"coverage_spread", row.coverage_spread},
                       {"equal", row.equal},
                       {"not_finite", row.not_finite},
                       {"sweep", row.sweep}});
    return all;
}

/// What was done, in words.
std::string what(const StabilityRow& row) {
    const std::string amount = amount_text(row.amount);
    switch (row.disturbance) {
        case Disturbance::eye:
            return "eye moved by " + amount;
        case Disturbance::shuffle:
            return "primitives in another order";
        case Disturbance::scale:
            return "everything times " + amount;
        case Disturbance::offset:
            return "everything moved by " + amount;
        case Disturbance::jitter:
            return "another jitter seed";
        case Disturbance::grazing:
            return "past a wall in steps of " + amount + "°";
    }
    return {};
}

std::string table(const std::vector<const StabilityRow*>& rows) {
    std::string html =
        "<table><tr><th class=t>method</th><th class=t>what was done</th><th>samples</th><th>Jaccard</th>"
        "<th>least</th><th>exact set</th><th>coverage changes by, %</th><th>spread, %</th><th>same order"
        "</th><th>not finite</th></tr>";
    const MethodLooks looks = MethodLooks::of(rows);
    for (const StabilityRow* row : rows)
        html += "<tr>" + looks.cell(row->method) + cell(what(*row), true) + cell(std::to_string(row->samples)) +
                cell(short_number(row->jaccard, 5)) + cell(short_number(row->jaccard_min, 5)) +
                cell(short_number(row->visible_jaccard, 5)) + cell(per_cent(row->coverage_change)) +
                cell(per_cent(row->coverage_spread)) + cell(row->equal ? "yes" : "no") +
                cell(std::to_string(row->not_finite)) + "</tr>";
    return html + "</table>";
}

std::string path_table(const Results& along_path) {
    if (along_path.rows.empty()) return {};
    std::string html =
        "<h2>Along a path</h2><table><caption>From frame to frame, in the mean. Popping counts primitives "
        "that are visible in both frames and rendered in one: no change of the exact set explains it."
        "</caption><tr><th class=t>scene</th><th class=t>method</th><th>budget</th><th>popping, %</th>"
        "<th>flipping pixels, %</th><th>the exact set changes by, %</th></tr>";
    std::vector<MethodChoice> methods;
    for (const Row& row : along_path.rows) methods.push_back(row.method);
    const MethodLooks looks(methods);
    for (const Row& row : along_path.rows)
        html += "<tr>" + cell(row.scene + ", " + row.path, true) + looks.cell(row.method) + cell(row.budget) +
                cell(per_cent(summary(row, Measure::pop))) + cell(per_cent(summary(row, Measure::flip))) +
                cell(per_cent(summary(row, Measure::visible_change))) + "</tr>";
    return html + "</table>";
}

}  // namespace

std::string stability_csv(const std::vector<StabilityRow>& rows) {
    std::string text =
        "scene,path,method,tessellation,budget,disturbance,amount,samples,jaccard,jaccard_min,visible_jaccard,"
        "coverage_change,coverage_spread,equal,not_finite\n";
    for (const StabilityRow& row : rows)
        text += csv_field(row.scene) + "," + csv_field(row.path) + "," + csv_field(row.method.variant) + "," +
                tessellation_word(row.method) + "," + csv_field(row.budget) + "," + std::string(disturbance_word(row)) +
                "," + number_text(row.amount) + "," + std::to_string(row.samples) + "," + number_text(row.jaccard) +
                "," + number_text(row.jaccard_min) + "," + number_text(row.visible_jaccard) + "," +
                number_text(row.coverage_change) + "," + number_text(row.coverage_spread) + "," +
                (row.equal ? "1" : "0") + "," + std::to_string(row.not_finite) + "\n";
    return text;
}

std::string stability_rows_json(const std::vector<StabilityRow>& rows) {
    return rows_json(rows).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<StabilityRow> read_stability_rows(const std::string& text) {
    std::vector<StabilityRow> rows;
    for (const Json& json : Json::parse(text)) {
        StabilityRow& row = rows.emplace_back();
        row.scene = json.at("scene");
        row.path = json.at("path");
        row.method.variant = json.at("method");
        row.method.tessellation = read_tessellation(json.at("tessellation").get<std::string>());
        row.budget = json.at("budget");
        const auto at =
            std::find(disturbance_words.begin(), disturbance_words.end(), json.at("disturbance").get<std::string>());
        if (at == disturbance_words.end()) throw InputError("stages of a study: an unknown disturbance");
        row.disturbance = static_cast<Disturbance>(at - disturbance_words.begin());
        row.amount = json.at("amount");
        row.samples = json.at("samples");
        row.jaccard = json.at("jaccard");
        row.jaccard_min = json.at("jaccard_min");
        row.visible_jaccard = json.at("visible_jaccard");
        row.coverage_change = json.at("coverage_change");
        row.coverage_spread = json.at("coverage_spread");
        row.equal = json.at("equal");
        row.not_finite = json.at("not_finite");
        row.sweep = json.at("sweep").get<std::vector<double>>();
    }
    return rows;
}

std::string stability_json(const Conditions& c, const std::vector<StabilityRow>& rows) {
    return Json{{"format", "sightline-stability"},
                {"version", 1},
                {"conditions", {{"study", Json::parse(c.study)}, {"build", c.build}, {"renderer", c.renderer}}},
                {"rows", rows_json(rows)}}
               .dump(1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

void write_stability(const Conditions& conditions, const std::vector<StabilityRow>& rows, const Results& along_path,
                     const std::filesystem::path& folder, const ChartFormat& format) {
    std::filesystem::create_directories(folder / "charts");
    write_file(folder / "stability.json", stability_json(conditions, rows));
    write_file(folder / "stability.csv", stability_csv(rows));
    std::string html =
        "<p>The set of primitives that a budget renders, before and after a disturbance that should not matter. "
        "Jaccard is "
        "|T ∩ T'| / |T ∪ T'|: 1 means the same set. Scaling by powers of two must keep the order bit by bit; NaN and "
        "infinite keys must not occur. The eye moves by the stated share of the scene's longest side.</p>";
    for (const StabilityGroup& group : stability_groups(rows)) {
        html += "<h2>" + escaped(group.scene + ", path " + group.path + ", budget " + group.budget) + "</h2>";
        for (const NamedChart& chart : stability_charts(group, along_path)) {
            write_chart(chart.chart, folder / "charts" / chart.id, format);
            html += picture(folder / "charts" / (chart.id + ".svg"), escaped(chart.text));
        }
        html += table(group.rows);
    }
    write_file(folder / "stability.html", page("Stability", html + path_table(along_path)));
}

}  // namespace sightline::lab
