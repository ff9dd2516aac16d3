// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/compare/compare_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/file.h"
#include "core/base/number.h"
#include "lab/report/method_looks.h"
#include "lab/report/page.h"

namespace sightline::lab {

namespace {

using Json = nlohmann::ordered_json;

bool better(const Change& change) {
    return (change.mean > 0) == (measure_row(change.measure).better == Better::higher);
}

const char* verdict(const Change& change) {
    if (change.mean == 0 && change.half_width == 0) return "same";
    if (!change.significant()) return "within the noise";
    return better(change) ? "better" : "worse";
}

const Change* of(const Pair& pair, Measure measure) {
    for (const Change& change : pair.changes)
        if (change.measure == measure) return &change;
    return nullptr;
}

/// Shares in per cent.
std::string value_text(Measure measure, double value) {
    return measure_row(measure).unit == "share" ? short_number(100 * value) : short_number(value);
}

std::string signed_text(Measure measure, double value) { return (value > 0 ? "+" : "") + value_text(measure, value); }

/// The two frames of a pair that changed most, on both sides.
template <int D>
void draw(const Pair& pair, const Change& change, const Side& a, const Side& b, const std::filesystem::path& folder,
          LabGraphics& graphics, std::vector<SideBySide>& drawn) {
    const std::string &scene = pair.a->scene, &path = pair.a->path;
    const Study study_a = at_error_bound(a.study, pair.a->error_bound),
                study_b = at_error_bound(b.study, pair.b->error_bound);
    const LabScene<D> lab_a = load_lab_scene<D>(scene, path, study_a), lab_b = load_lab_scene<D>(scene, path, study_b);
    for (const bool lost : {true, false}) {
        const std::size_t frame = lost ? change.lost : change.gained;
        const auto in_b = std::find(pair.b->frames.begin(), pair.b->frames.end(), pair.a->frames[frame]);
        const std::string stem = file_stem(scene + "-" + path + (lost ? "-lost" : "-gained"));
        drawn.push_back({pair_title(pair) + ": the frame that " + (lost ? "lost" : "gained") + " most",
                         draw_frame<D>(lab_a, study_a, *pair.a, frame, folder / (stem + "-a.png"), graphics),
                         draw_frame<D>(lab_b, study_b, *pair.b, static_cast<std::size_t>(in_b - pair.b->frames.begin()),
                                       folder / (stem + "-b.png"), graphics)});
    }
}

bool has_times(const std::vector<Pair>& pairs, const std::string& scene, const std::string& path) {
    return std::any_of(pairs.begin(), pairs.end(), [&](const Pair& pair) {
        return pair.a->scene == scene && pair.a->path == path && of(pair, Measure::total_ms);
    });
}

}  // namespace

std::string pair_title(const Pair& pair) {
    const std::string a = method_text(pair.a->method), b = method_text(pair.b->method);
    return pair.a->scene + ", path " + pair.a->path + ", " + (a == b ? a : a + " and " + b) + " at " + pair.a->budget;
}

std::string change_text(const Change& change) {
    const MeasureRow& row = measure_row(change.measure);
    return std::string(row.title) + " " + value_text(change.measure, change.a) + " -> " +
           value_text(change.measure, change.b) + (row.unit == "share" ? " %" : "") + " (" +
           signed_text(change.measure, change.mean) + " ± " + value_text(change.measure, change.half_width) +
           "): " + verdict(change);
}

std::vector<SideBySide> draw_side_by_side(const Comparison& comparison, const std::filesystem::path& folder,
                                          LabGraphics& graphics) {
    std::map<std::pair<std::string, std::string>, const Pair*> chosen;
    const auto amount = [](const Pair& pair) {
        const Change* change = of(pair, Measure::wrong);
        return change ? std::abs(change->mean) : 0;
    };
    for (const Pair& pair : comparison.pairs) {
        const Pair*& best = chosen[{pair.a->scene, pair.a->path}];
        if (!best || amount(pair) > amount(*best)) best = &pair;
    }
    std::vector<SideBySide> drawn;
    std::filesystem::create_directories(folder);
    for (const auto& [place, pair] : chosen) {
        const Change* change = of(*pair, Measure::wrong);
        if (!change || amount(*pair) == 0) continue;
        if (parse_scene(place.first).dimension == 2)
            draw<2>(*pair, *change, comparison.a, comparison.b, folder, graphics, drawn);
        else
            draw<3>(*pair, *change, comparison.a, comparison.b, folder, graphics, drawn);
    }
    return drawn;
}

std::vector<std::string> notes_of(const Comparison& comparison) {
    const auto& [a, b, two_runs, pairs] = comparison;
    std::vector<std::string> notes;
    if (two_runs) {
        const Conditions &x = a.conditions, &y = b.conditions;
        notes.push_back(x.program == y.program ? "The same build of the program measured both."
                                               : "Two builds of the program: what changed may be the code.");
        if (x.machine != y.machine || x.renderer != y.renderer)
            notes.push_back("Times come from two machines: " + x.machine + ", " + x.renderer + " and " + y.machine +
                            ", " + y.renderer + ".");
        std::set<std::pair<std::string, std::string>> places;
        for (const Pair& pair : pairs) places.insert({pair.a->scene, pair.a->path});
        for (const auto& [scene, path] : places) {
            if (!has_times(pairs, scene, path)) continue;
            const auto share = machine_change(pairs, scene, path);
            notes.push_back(
                scene + ", path " + path + ": " +
                (share ? "the machine alone changed times by up to " + short_number(100 * *share) +
                             " % (view and everything, which no heuristic touches); less than that counts as noise."
                       : "neither view nor everything is in both studies, so a busy machine can look like a change "
                         "of times."));
        }
    }
    std::size_t numbers = 0, changed = 0;
    for (const Pair& pair : pairs)
        for (const Change& change : pair.changes) {
            numbers += change.mean != 0 || change.half_width != 0;
            changed += change.significant();
        }
    notes.push_back(std::to_string(changed) + " of " + std::to_string(numbers) +
                    " numbers that differ do so by more than the noise; chance alone would account for about " +
                    std::to_string((numbers + 10) / 20) + ".");
    return notes;
}

void write_comparison(const Comparison& comparison, const std::vector<SideBySide>& pictures,
                      const std::filesystem::path& folder) {
    const auto& [a, b, two_runs, pairs] = comparison;
    std::filesystem::create_directories(folder);
    Json json{{"format", "sightline-comparison"}, {"version", 1}, {"a", a.name}, {"b", b.name}};
    std::string html =
        "<p>A is <b>" + escaped(a.name) + "</b>, B is <b>" + escaped(b.name) +
        "</b>. Differences are paired frame by frame; ± is half of the 95 % confidence interval of their mean, over "
        "frames and repeats. Within the noise means that the interval holds 0, or that the machine explains it.</p>"
        "<ul>";
    for (const std::string& note : notes_of(comparison)) {
        html += "<li>" + escaped(note) + "</li>";
        json["notes"].push_back(note);
    }
    html += "</ul>";
    json["pairs"] = Json::array();
    std::vector<MethodChoice> methods;
    for (const Pair& pair : pairs) methods.insert(methods.end(), {pair.a->method, pair.b->method});
    const MethodLooks looks(methods);
    for (const Pair& pair : pairs) {
        Json one{{"scene", pair.a->scene},
                 {"path", pair.a->path},
                 {"method_a", method_text(pair.a->method)},
                 {"method_b", method_text(pair.b->method)},
                 {"budget", pair.a->budget}};
        html += "<h3>" + escaped(pair_title(pair)) + "</h3><table><tr><th class=t>measure</th><th>" +
                swatch(looks.look(pair.a->method)) + "A</th><th>" + swatch(looks.look(pair.b->method)) +
                "B</th><th>B - A</th><th>±</th><th class=t></th><th>lost most in frame</th><th>gained most in "
                "frame</th></tr>";
        for (const Change& c : pair.changes) {
            const MeasureRow& m = measure_row(c.measure);
            const std::string says = verdict(c);
            html += "<tr>" +
                    cell(std::string(m.title) + (m.unit == "share" ? ", %" : ", " + std::string(m.unit)), true) +
                    cell(value_text(c.measure, c.a)) + cell(value_text(c.measure, c.b)) +
                    cell(signed_text(c.measure, c.mean)) + cell(value_text(c.measure, c.half_width)) + "<td class='t " +
                    (says == "better"  ? "holds"
                     : says == "worse" ? "not"
                                       : "noise") +
                    "'>" + says + "</td>" + cell(std::to_string(pair.a->frames[c.lost])) +
                    cell(std::to_string(pair.a->frames[c.gained])) + "</tr>";
            one["changes"].push_back({{"measure", m.id},
                                      {"a", c.a},
                                      {"b", c.b},
                                      {"mean", c.mean},
                                      {"half_width", c.half_width},
                                      {"machine", c.machine},
                                      {"frames", c.frames},
                                      {"verdict", says},
                                      {"lost_frame", pair.a->frames[c.lost]},
                                      {"gained_frame", pair.a->frames[c.gained]}});
        }
        html += "</table>";
        json["pairs"].push_back(std::move(one));
    }
    if (!pictures.empty()) html += "<h2>The frames that changed most</h2>";
    for (const SideBySide& two : pictures) {
        html += "<h3>" + escaped(two.title) + "</h3><div class=pictures>";
        for (const auto& [name, p] : {std::pair("A", &two.a), std::pair("B", &two.b)})
            html += picture(p->file, "<b>" + std::string(name) + "</b>: " + escaped(p->method) + ", frame " +
                                         std::to_string(p->frame) + ", " + per_cent(p->wrong) + " % wrong.<br><code>" +
                                         escaped(p->command) + "</code>");
        html += "</div>";
    }
    write_file(folder / "compare.json", json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    write_file(folder / "compare.html", page("What changed", html));
}

}  // namespace sightline::lab
