// What a method that chooses by viewpoint knows of where the eye stands and looks: what it chose here, and why.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "shell/desk/work_out.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

std::string turned_text(double degrees) {
    return (degrees < 0 ? "−" : "") + short_number(degrees < 0 ? -degrees : degrees, 4) + "°";
}
std::string from_to(const std::array<double, 2>& degrees) {
    return turned_text(degrees[0]) + " to " + turned_text(degrees[1]);
}

/// A cap: round as a whole.
bool is_round(const DirectionFact& direction) { return direction.azimuth[1] - direction.azimuth[0] >= 360; }

/// "looking down", "level", …, with the elevations.
std::string band_text(const DirectionFact& direction) {
    const auto& [low, high] = direction.elevation;
    const std::string way = low < 0 && high > 0 ? "level" : high <= 0 ? "down" : "up";
    return (is_round(direction) ? "straight " : "") + way + ", " + from_to(direction.elevation);
}

template <int D>
void add_techniques(const ViewpointFact<D>& fact, std::vector<Row>& rows) {
    rows.push_back({"Techniques here, with the milliseconds predicted for a frame", Tone::heading});
    for (std::uint32_t i = 0; i < fact.techniques.size(); ++i) {
        const TechniqueFact& technique = fact.techniques[i];
        Row& row = rows.emplace_back(Row{technique.name + ": " + milliseconds_text(technique.ms())});
        if (i == fact.chosen) row.text += ", chosen";
        if (i == fact.done && i != fact.chosen) row.text += ", the one of the frame before";
        row.tone = i == fact.done ? Tone::lit : Tone::plain;
        row.command = "method \"" + technique.name + "\"";
        row.indent = 1;
        row.tip = "culling " + short_number(technique.cull_ms) + " ms + drawing " + short_number(technique.draw_ms) +
                  " ms, " + counted(static_cast<std::size_t>(technique.drawn + 0.5), "primitive") +
                  "; a click runs it alone";
    }
    if (fact.done != fact.chosen)
        rows.push_back({"changing to " + fact.techniques[fact.chosen].name +
                            " would not pay: " + fact.techniques[fact.done].name + " stays",
                        Tone::lit});
}

template <int D>
void add_rose(const ViewpointFact<D>& fact, std::vector<Row>& rows) {
    rows.push_back(
        {D == 2 ? "Directions from this region, by azimuth" : "Directions from this region, by elevation and azimuth",
         Tone::heading});
    const std::array<double, 2>* band = nullptr;
    for (std::uint32_t i = 0; i < fact.rose.size(); ++i) {
        const DirectionFact& direction = fact.rose[i];
        const std::string chosen =
            direction.technique == none ? "not worked out" : fact.techniques[direction.technique].name;
        if (D == 3 && !is_round(direction) && (!band || *band != direction.elevation)) {
            rows.push_back({band_text(direction), Tone::plain});
            band = &direction.elevation;
        }
        Row& row = rows.emplace_back();
        row.text = (is_round(direction) ? band_text(direction) : from_to(direction.azimuth)) + ": " + chosen;
        if (i == fact.interval_here) row.text += ", looked into";
        row.tone = i == fact.interval_here ? Tone::lit : direction.technique == none ? Tone::faint : Tone::plain;
        row.indent = is_round(direction) ? 0 : 1;
    }
}

template <int D>
void add_table(const Workbench<D>& bench, const ViewpointFact<D>& fact, std::vector<Row>& rows) {
    rows.push_back({"What the table knows", Tone::heading});
    rows.push_back({std::to_string(fact.known) + " of " + counted(fact.entries, "entry") + " worked out: " +
                    counted(fact.map.size(), "region") + ", each with " + counted(fact.rose.size(), "direction")});
    if (const std::string work = work_out_text(bench); !work.empty()) {
        rows.push_back({"working out: " + work + " (click to stop)", Tone::lit, "work-out stop"});
        return;
    }
    if (fact.known == fact.entries) return;
    const auto unknown =
        static_cast<std::size_t>(std::count_if(fact.rose.begin(), fact.rose.end(), [](const DirectionFact& direction) {
            return direction.technique == none;
        }));
    rows.push_back({"work out the next entry and go there", Tone::link, "viewpoint next"});
    if (unknown > 0)
        rows.push_back({"work out this region: " + counted(unknown, "entry"), Tone::link, "work-out region"});
    rows.push_back({"work out all: " + counted(fact.entries - fact.known, "entry"), Tone::link, "work-out all"});
}

}  // namespace

template <int D>
std::vector<Row> viewpoint_rows(const Workbench<D>& bench) {
    const auto fact = bench.session.traversal().viewpoint();
    if (!fact)
        return {{"Choice by viewpoint", Tone::heading},
                {"this method is the same wherever the eye stands"},
                {"method by-viewpoint shows which technique it would choose here", Tone::link, "method by-viewpoint"}};
    std::vector<Row> rows{{"The eye is in " + fact->region, Tone::heading},
                          {"and looks along " + fact->interval},
                          {"done here: " + fact->techniques[fact->done].name, Tone::lit}};
    add_techniques(*fact, rows);
    rows.push_back({"Decisions, with the milliseconds after each", Tone::heading});
    for (std::size_t i = 0; i < fact->decisions.size(); ++i) {
        const Decision& decision = fact->decisions[i];
        Row& row = rows.emplace_back(Row{std::to_string(i + 1) + ". " + decision.sentence});
        row.indent = 1;
        row.tip = "after it: " + short_number(decision.ms) + " ms";
    }
    if (!fact->occluders.empty())
        rows.push_back(
            {counted(fact->occluders.size(), "primitive") + " of the largest occluders seen from here", Tone::faint});
    add_table(bench, *fact, rows);
    add_rose(*fact, rows);
    return rows;
}

template std::vector<Row> viewpoint_rows<2>(const Workbench<2>&);
template std::vector<Row> viewpoint_rows<3>(const Workbench<3>&);

}  // namespace sightline
