// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/report/papers_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "core/base/quote.h"
#include "lab/report/claims.h"
#include "lab/report/page.h"
#include "lab/report/study_charts.h"

namespace sightline::lab {

namespace {

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

/// What the papers print of a scene of theirs (TVCG table 1 and section 5.1), on Delaunay cells.
struct Printed {
    std::string_view scene;
    std::array<double, 4> coverage;
    double cells, bytes_per_cell, references, memory_share, seconds;
};
/// Bytes: "less than 100" for CITY; for 5CBEM 20 MB in all without 14.7 MB of references, over 60K cells.
constexpr std::array<Printed, 2> printed{{{"CITY", {0.51, 0.66, 0.80, 0.90}, 25e3, 100, 1.80, 0.12, 70},
                                          {"5CBEM", {0.44, 0.55, 0.67, 0.76}, 60e3, 88, 2.13, 0.24, 135}}};

const Printed* printed_of(const std::string& scene) {
    const char* theirs = papers_name(scene);
    for (const Printed& p : printed)
        if (theirs && p.scene == theirs) return &p;
    return nullptr;
}

std::string whole(double value) { return std::isnan(value) ? "–" : std::to_string(std::llround(value)); }

}  // namespace

std::vector<Table1Row> table_1(const Results& results) {
    static constexpr std::array budgets{"1%", "2%", "5%", "10%"};
    std::vector<Table1Row> table;
    for (const Group& group : groups(results)) {
        const Printed* theirs = printed_of(group.scene);
        if (!theirs || part_of_path(group.path)) continue;
        for (const Tessellation kind : {Tessellation::delaunay, Tessellation::tree}) {
            const MethodChoice method{"published", kind};
            Table1Row row{group.scene,
                          group.path,
                          std::string(theirs->scene),
                          method_text(method),
                          {budgets.begin(), budgets.end()},
                          {},
                          {}};
            bool any = false;
            for (std::size_t b = 0; b < budgets.size(); ++b) {
                const auto found = std::find_if(group.rows.begin(), group.rows.end(), [&](const Row* r) {
                    return r->method == method && r->budget == budgets[b];
                });
                const bool is_there = found != group.rows.end();
                row.ours.push_back(is_there ? summary(**found, Measure::coverage) : not_there);
                row.papers.push_back(kind == Tessellation::delaunay ? theirs->coverage[b] : not_there);
                any |= is_there;
            }
            if (any) table.push_back(std::move(row));
        }
    }
    return table;
}

std::vector<PreprocessingRow> preprocessing(const Results& results) {
    std::vector<PreprocessingRow> table;
    std::set<std::tuple<std::string, Tessellation, double>> seen;
    const Printed* last = nullptr;
    const auto add_theirs = [&](const Printed* theirs) {
        if (theirs)
            table.push_back({std::string(theirs->scene) + " (TVCG 5.1)", "delaunay", theirs->cells,
                             theirs->bytes_per_cell, theirs->references, theirs->memory_share, theirs->seconds});
    };
    for (const Row& row : results.rows) {
        const CellNumbers& n = row.tessellation;
        if (n.scene_bytes == 0) continue;  // older results
        if (!seen.insert({row.scene, row.method.tessellation, row.error_bound}).second) continue;
        const Printed* theirs = printed_of(row.scene);
        if (theirs != last) add_theirs(last);
        last = theirs;
        table.push_back({row.scene, std::string(words<Tessellation>[static_cast<std::size_t>(row.method.tessellation)]),
                         double{1} * row.cells, static_cast<double>(n.cell_bytes) / std::max(1u, row.cells),
                         static_cast<double>(n.references) / std::max(1u, row.primitives),
                         static_cast<double>(n.cell_bytes + n.reference_bytes) / static_cast<double>(n.scene_bytes),
                         n.seconds, n});
    }
    add_theirs(last);
    return table;
}

TextTable text_table(const std::vector<Table1Row>& table) {
    TextTable text{{"scene, path", "method"}, {}};
    if (table.empty()) return text;
    text.head.insert(text.head.end(), table.front().budgets.begin(), table.front().budgets.end());
    std::string theirs;
    for (const Table1Row& row : table) {
        if (row.papers_scene != theirs) {
            // Theirs stand once, above ours.
            theirs = row.papers_scene;
            text.rows.push_back({theirs + " (TVCG table 1)", row.method});
            for (const double share : row.papers) text.rows.back().push_back(per_cent(share));
        }
        text.rows.push_back({row.scene + ", " + row.path, row.method});
        for (const double share : row.ours) text.rows.back().push_back(per_cent(share));
    }
    return text;
}

TextTable text_table(const std::vector<PreprocessingRow>& table) {
    TextTable text{{"scene", "tessellation", "cells", "bytes per cell", "references per primitive",
                    "memory over the primitives %", "seconds", "cells a line crosses", "most",
                    "cells an eye ray crosses", "empty cells %", "primitives in the others", "spread"},
                   {}};
    for (const PreprocessingRow& row : table) {
        const CellNumbers& n = row.numbers;
        const auto mean = [](const Stabbing& s) { return number(s.lines > 0 ? s.mean : not_there); };
        const bool ours = n.scene_bytes > 0;
        text.rows.push_back({row.scene, row.tessellation, whole(row.cells), whole(row.bytes_per_cell),
                             number(row.references_per_primitive), per_cent(row.memory_share), number(row.seconds),
                             mean(n.lines), n.lines.lines > 0 ? std::to_string(n.lines.most) : "–", mean(n.eye_rays),
                             ours ? per_cent(n.density.empty) : "–", ours ? number(n.density.mean) : "–",
                             ours ? number(n.density.deviation) : "–"});
    }
    return text;
}

std::string html(const TextTable& table, const std::string& caption) {
    std::string text = "<table><caption>" + escaped(caption) + "</caption><tr>";
    for (std::size_t i = 0; i < table.head.size(); ++i)
        text += (i < 2 ? "<th class=t>" : "<th>") + escaped(table.head[i]) + "</th>";
    text += "</tr>";
    for (const auto& row : table.rows) {
        text += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) text += cell(row[i], i < 2);
        text += "</tr>";
    }
    return text + "</table>";
}

std::string markdown(const TextTable& table) {
    const auto line = [](const std::vector<std::string>& row) {
        std::string text = "|";
        for (const std::string& one : row) text += " " + markdown_escaped(one) + " |";
        return text + "\n";
    };
    std::string text = line(table.head) + "|";
    for (std::size_t i = 0; i < table.head.size(); ++i) text += "---|";
    text += "\n";
    for (const auto& row : table.rows) text += line(row);
    return text;
}

}  // namespace sightline::lab
