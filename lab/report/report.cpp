// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/report.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/base/file.h"
#include "core/base/number.h"
#include "lab/report/gem_table.h"
#include "lab/report/method_looks.h"
#include "lab/report/page.h"
#include "lab/report/papers_tables.h"
#include "lab/report/time_table.h"
#include "lab/report/winners.h"

namespace sightline::lab {

namespace {

namespace fs = std::filesystem;

std::string conditions(const Results& results) {
    const Conditions& c = results.conditions;
    const auto study = nlohmann::ordered_json::parse(c.study);
    std::string html = "<p class=lead>Taken " + escaped(c.date) + " on " + escaped(c.machine) + "; " +
                       escaped(c.build) + (c.renderer.empty() ? "" : "; " + escaped(c.renderer)) + ". Reference size " +
                       escaped(study.value("size", "")) + " (auto: 1024x768, in 2D 8192); times are medians of " +
                       std::to_string(study.value("repeats", 0)) + " runs, then over frames.</p>";
    if (!study.at("settings").empty())
        html += "<p>Settings of every scene: <code>" + escaped(study.at("settings").dump()) + "</code></p>";
    std::string conservative;
    for (const Row& row : results.rows)
        if (const std::string name = "<b>" + escaped(method_text(row.method)) + "</b>";
            !row.approximate && conservative.find(name) == std::string::npos)
            conservative += (conservative.empty() ? "" : ", ") + name;
    return html + "<p>Methods are approximate: they may miss visible primitives." +
           (conservative.empty() ? "" : " These never do at the reference size: " + conservative + ".") +
           " <b>perfect</b> draws exactly the visible ones, which it is told: no method can do better.</p>";
}

std::string answers(const std::vector<Group>& all) {
    static constexpr std::array limits{5.0, 10.0, 16.0, 33.0, 100.0};
    std::string html =
        "<h2>Which method in the time available?</h2><table><caption>Fewest wrong pixels within a time per "
        "frame, mean over frames: method, budget, wrong pixels. Of equals the one that never misses "
        "anything.</caption><tr><th class=t>scene</th>";
    for (const double ms : limits) html += "<th>" + short_number(ms) + " ms</th>";
    html += "</tr>";
    for (const Group& group : all) {
        html += "<tr>" + cell(group.scene + ", " + group.path, true);
        for (const double ms : limits) {
            const Row* best = best_within(group, ms);
            html += cell(best ? method_text(best->method) + (best->budget == "unlimited" ? "" : " " + best->budget) +
                                    ": " + per_cent(summary(*best, Measure::wrong)) + " %" +
                                    (best->approximate ? "" : ", never misses")
                              : "–");
        }
        html += "</tr>";
    }
    return html + "</table>";
}

std::string caption(const FramePicture& p) {
    return "<b>" + escaped(p.scene + ", " + p.method + " at " + p.budget) + "</b>: frame " + std::to_string(p.frame) +
           " of path " + escaped(p.path) + ", " + per_cent(p.wrong) + " % wrong.<br><code>" + escaped(p.command) +
           "</code>";
}

std::string tables_of_papers(const Results& results) {
    std::string text;
    if (const TextTable table = winners_table(results); !table.rows.empty())
        text += "<h2>Who wins where</h2>" + html(table, winners_text(results));
    if (const std::vector<Table1Row> table = table_1(results); !table.empty())
        text += "<h2>Table 1 of the papers</h2>" + html(text_table(table), table_1_caption);
    if (const TextTable table = gem_table(results); !table.rows.empty())
        text += "<h2>The gem's power plant</h2>" + html(table, gem_caption);
    if (const std::vector<PreprocessingRow> table = preprocessing(results); !table.empty())
        text += "<h2>Preprocessing</h2>" + html(text_table(table), preprocessing_caption);
    return text;
}

std::string claims(const std::vector<Claim>& all, const std::map<std::size_t, FramePicture>& pictures) {
    if (all.empty()) return {};
    std::string text =
        "<h2>What the papers say, and what we find</h2><table><tr><th class=t>they</th><th class=t>we</th>"
        "<th class=t></th></tr>";
    for (const Claim& claim : all) {
        static constexpr std::array classes{"holds", "not", "waits"};  // by Judgement
        text +=
            "<tr>" + cell(claim.text + " (" + claim.source + (claim.test.empty() ? "" : "; " + claim.test) + ")", true);
        std::string ours;
        for (const Regime& regime : claim.regimes)
            ours += (ours.empty() ? "" : "<br>") + escaped(regime_text(claim, regime));
        text += "<td class=t>" + ours + "</td><td class='t " + classes[static_cast<std::size_t>(judgement(claim))] +
                "'>" + escaped(verdict_text(claim)) + "</td></tr>";
    }
    text +=
        "</table><p>" + escaped(claims_note) +
        "</p><p>Where a claim does not hold, here is the worst frame of what it is about; for claims about time see "
        "the charts below.</p><div class=pictures>";
    for (const auto& [index, shown] : pictures)
        text += picture(shown.file, "“" + escaped(all[index].text) + "” – " + escaped(verdict_text(all[index])) +
                                        "<br>" + caption(shown));
    return text + "</div>";
}

std::string table_of_rows(const Group& group) {
    static constexpr std::array columns{Measure::coverage,    Measure::coverage_px, Measure::oracle,
                                        Measure::cell_oracle, Measure::wrong,       Measure::blob,
                                        Measure::pop,         Measure::flip,        Measure::zero_keys};
    std::string html = "<table><caption>Means over " + std::to_string(group.rows.front()->frames.size()) +
                       " frames in %; wrong pixels also for the worst frame; " +
                       escaped(group.rows.front()->reference) +
                       ".</caption><tr><th class=t>method</th><th>cells</th>"
                       "<th>budget</th>";
    for (const Measure m : columns) html += "<th>" + std::string(measure_row(m).title) + "</th>";
    html += "<th>worst wrong</th><th>r of key and share</th><th>ms</th></tr>";
    const MethodLooks looks = MethodLooks::of(group.rows);
    for (const Row* row : group.rows) {
        html += "<tr>" + looks.cell(row->method) + cell(std::to_string(row->cells)) + cell(row->budget);
        for (const Measure m : columns) html += cell(per_cent(summary(*row, m)));
        html += cell(per_cent(worst(*row, Measure::wrong))) + cell(number(summary(*row, Measure::key_rank))) +
                cell(number(summary(*row, Measure::total_ms))) + "</tr>";
    }
    return html + "</table>";
}

std::string worst_frames(const std::vector<FramePicture>& worst) {
    if (worst.empty()) return {};
    std::string html =
        "<h2>The worst frames</h2><p>What the budget rendered; red is what it should have shown "
        "(TVCG fig. 14; in 2D the missed segments).</p><div class=pictures>";
    for (const FramePicture& w : worst) html += picture(w.file, caption(w));
    return html + "</div>";
}

std::string measures() {
    std::string html =
        "<h2>What the numbers mean</h2><table><tr><th class=t>number</th><th class=t>unit</th><th "
        "class=t>is</th><th class=t>source</th></tr>";
    for (const MeasureRow& m : measure_table())
        html += "<tr>" + cell(std::string(m.title), true) + cell(std::string(m.unit), true) +
                cell(std::string(m.formula), true) + cell(std::string(m.source), true) + "</tr>";
    return html + "</table>";
}

}  // namespace

const Row* best_within(const Group& group, double ms) {
    const Row* best = nullptr;
    // Of two that are as right the one that never misses anything, then the faster one.
    const auto key = [](const Row& row) {
        return std::tuple(summary(row, Measure::wrong), row.approximate, summary(row, Measure::total_ms));
    };
    for (const Row* row : group.rows) {
        const double wrong = summary(*row, Measure::wrong);
        if (row->method.variant == exactly_v) continue;  // nobody is told V
        if (!(summary(*row, Measure::total_ms) <= ms) || std::isnan(wrong)) continue;
        if (!best || key(*row) < key(*best)) best = row;
    }
    return best;
}

void write_report(const Results& results, const std::vector<Claim>& judged, const ReportPictures& pictures,
                  const fs::path& folder, const ChartFormat& format) {
    fs::create_directories(folder / "charts");
    const std::vector<Group> all = groups(results);
    const std::vector<NamedChart> charts = study_charts(results);
    std::string html = conditions(results) + answers(all) + claims(judged, pictures.claims) + tables_of_papers(results);
    if (!results.flights.empty())
        html += "<h2>Budgets in time</h2>" + sightline::lab::html(budget_table(results), budget_caption);
    if (!results.wrong_flights.empty())
        html += "<h2>Budgets in wrong pixels</h2>" +
                sightline::lab::html(wrong_budget_table(results), wrong_budget_caption);
    for (const Group& group : all) {
        html += "<h2>" + escaped(group.scene) + ", path " + escaped(group.path) + "</h2>";
        for (const std::vector<NamedChart>* const some : {&charts, &pictures.keys})
            for (const NamedChart& chart : *some) {
                if (chart.scene != group.scene || chart.path != group.path) continue;
                write_chart(chart.chart, folder / "charts" / chart.id, format);
                html += picture(folder / "charts" / (chart.id + ".svg"), escaped(chart.text));
            }
        html += table_of_rows(group) + sightline::lab::html(time_table(group), time_caption);
    }
    html += worst_frames(pictures.worst) + measures();
    write_file(folder / "report.html", page("Speed against accuracy", html));
}

}  // namespace sightline::lab
