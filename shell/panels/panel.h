// Panels as data: what each says, line by line, with what a click on a line does. The window draws them, the command
// `panels` writes them as text. Adding one is a file and a row of the table.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/draw/key_light.h"
#include "shell/desk/workbench.h"

namespace sightline {

/// How a line is meant.
enum class Tone : std::uint8_t { plain, heading, faint, good, bad, lit, link };

struct Row {
    std::string text;
    Tone tone = Tone::plain;
    std::string command{};      ///< what a click runs; empty: nothing
    std::uint32_t cell = none;  ///< outlined everywhere while the mouse is over the line
    int indent = 0;
    std::string tip{};  ///< shown while the mouse rests on it
    /// A formula: its text in pieces, whose terms have colours and light up `light` while the mouse is over them.
    std::vector<KeyPart> parts{};
    KeyLight light{};
    bool captions = false;  ///< each term's name under its number
};

/// The column of the window that a panel stands in.
enum class Column : std::uint8_t { left, right };

/// The tabs of a column are in groups, each with what belongs to one question.
enum class PanelGroup : std::uint8_t { step, run, notes, lab };
inline constexpr auto panel_group_titles = std::to_array<std::string_view>({"This step", "This run", "Notes", "Lab"});

/// What the window makes of a panel.
enum class Body : std::uint8_t {
    rows,     ///< its rows
    widgets,  ///< a widget for each of its rows
    chart,    ///< a chart, which stays where it is, over its rows; measured while a person looks at it
};

template <int D>
struct Panel {
    std::string_view id;
    std::string_view title;
    std::string_view text;  ///< what it is for, one line
    Column column = Column::right;
    PanelGroup group = PanelGroup::lab;
    std::vector<Row> (*rows)(const Workbench<D>&);
    Body body = Body::rows;
    bool fixed = false;  ///< says the same whatever is on the bench
};

template <int D>
std::span<const Panel<D>> panel_table();

/// Rows without the key that an exercise asks for (conceal); a row that held it loses the colours of its formula.
template <int D>
std::vector<Row> conceal_rows(const Workbench<D>& bench, std::vector<Row> rows);

/// What the panel says to those who may read it now.
template <int D>
std::vector<Row> panel_rows(const Panel<D>& panel, const Workbench<D>& bench) {
    return conceal_rows(bench, panel.rows(bench));
}

/// nullptr when there is no panel of this id.
template <int D>
const Panel<D>* find_panel(std::string_view id);

/// A row as a line of text.
inline std::string as_line(const Row& row) {
    return std::string(2 * static_cast<std::size_t>(row.indent), ' ') + row.text;
}

/// All panels that are not fixed as text, each under its title.
template <int D>
std::string panels_text(const Workbench<D>& bench);

}  // namespace sightline
