// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/panels/panel_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/number.h"
#include "shell/desk/conceal.h"

namespace sightline {

template <int D>
std::span<const Panel<D>> panel_table() {
    using enum PanelGroup;
    constexpr Column right = Column::right;
    static constexpr std::array table{
        Panel<D>{"why", "Why", "why this cell now, and why the selected cell not yet", right, step, why_rows<D>},
        Panel<D>{"code", "Code", "the algorithm, with the current line and its values", right, step, code_rows<D>},
        Panel<D>{"run", "Run", "the state of the run, and its conditions", right, run, run_rows<D>},
        Panel<D>{"missed", "Missed", "the wrong pixels of this run, and a click to why", right, run, missed_rows<D>},
        Panel<D>{"objects", "Objects", "what is missed and drawn in vain, object by object", right, run,
                 object_rows<D>},
        Panel<D>{"inversions", "Inversions", "hidden cells projected before visible ones", right, run,
                 inversion_rows<D>},
        Panel<D>{"viewpoint", "Viewpoint", "which technique is chosen where the eye is, and why", right, run,
                 viewpoint_rows<D>},
        Panel<D>{"compare", "Compare", "two sessions beside each other", right, run, compare_rows<D>},
        Panel<D>{"trade-off", "Trade-off", "speed against accuracy for every method in this scene", right, run,
                 trade_off_rows<D>, Body::chart},
        Panel<D>{"notes", "Notes", "notes and bookmarks", right, notes, note_rows<D>},
        Panel<D>{"words", "Glossary", "what each term means and where it is defined", right, notes, glossary_rows<D>,
                 Body::rows, true},
        Panel<D>{"front", "Front", "the cells in the front, first to last", right, lab, front_rows<D>},
        Panel<D>{"breakpoints", "Breakpoints", "breakpoints and marked steps", right, lab, breakpoint_rows<D>},
        Panel<D>{"techniques", "Techniques", "which techniques suit this scene, and which of them are here", right, lab,
                 technique_rows<D>},
        Panel<D>{"settings", "Settings", "every setting with its source", Column::left, lab, settings_rows<D>,
                 Body::widgets},
    };
    return table;
}

template <int D>
const Panel<D>* find_panel(std::string_view id) {
    const auto table = panel_table<D>();
    const auto found = std::find_if(table.begin(), table.end(), [&](const Panel<D>& p) { return p.id == id; });
    return found == table.end() ? nullptr : &*found;
}

template <int D>
std::vector<Row> conceal_rows(const Workbench<D>& bench, std::vector<Row> rows) {
    if (concealed_cell(bench) == none) return rows;
    for (Row& row : rows) {
        const std::string told = std::exchange(row.text, conceal(bench, row.text));
        row.tip = conceal(bench, row.tip);
        if (row.text != told) row.parts.clear();
    }
    return rows;
}

template <int D>
std::string panels_text(const Workbench<D>& bench) {
    std::string text;
    for (const Panel<D>& panel : panel_table<D>()) {
        if (panel.fixed) continue;
        text += "== " + std::string(panel.title) + " ==\n";
        for (const Row& row : panel_rows(panel, bench)) text += as_line(row) + "\n";
        text += "\n";
    }
    if (bench.places.empty()) return text;
    text += "== Screen ==\n";
    for (const Place& place : bench.places)
        text += place.name + ": " + number_text(place.x) + " " + number_text(place.y) + " " + number_text(place.w) +
                " " + number_text(place.h) + "\n";
    return text;
}

template std::span<const Panel<2>> panel_table<2>();
template std::span<const Panel<3>> panel_table<3>();
template const Panel<2>* find_panel<2>(std::string_view);
template const Panel<3>* find_panel<3>(std::string_view);
template std::vector<Row> conceal_rows<2>(const Workbench<2>&, std::vector<Row>);
template std::vector<Row> conceal_rows<3>(const Workbench<3>&, std::vector<Row>);
template std::string panels_text<2>(const Workbench<2>&);
template std::string panels_text<3>(const Workbench<3>&);

}  // namespace sightline
