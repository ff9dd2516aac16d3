// The traversal of cells as lines in our own words, filled with the values of a step: TVCG figs 4 and 5 (TR figs 5, 6).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/number.h"
#include "core/methods/cells/cell_base.h"

namespace sightline {

namespace {

std::string cell_and_key(std::uint32_t cell, double key, int digits) {
    return "cell " + std::to_string(cell) + ", key " + short_number(key, digits);
}

/// Where in the last step: between two steps, at the pop, at the rendering, or at a facet of the cell.
struct CellPlace {
    enum class At : std::uint8_t { between, pop, render, facet };
    At at = At::between;
    std::optional<Considered> facet;
    std::size_t facet_number = 0;  ///< from 1
    std::size_t facet_count = 0;

    bool in_step() const { return at != At::between; }
    bool rendered() const { return at == At::render || at == At::facet; }
    bool is(std::initializer_list<Rule> rules) const {
        return facet && std::find(rules.begin(), rules.end(), Rule{facet->rule}) != rules.end();
    }
};

CellPlace place_of(const CodePlace& place, std::vector<Considered> considered) {
    CellPlace at;
    if (!place.in_step()) return at;
    at.facet_count = considered.size();
    at.at = *place.substep == 0   ? CellPlace::At::pop
            : *place.substep == 1 ? CellPlace::At::render
                                  : CellPlace::At::facet;
    if (*place.substep < first_facet_substep) return at;
    at.facet_number = *place.substep - 1;
    at.facet = std::move(considered[at.facet_number - 1]);
    return at;
}

/// What happens to the cell n behind a facet: one line for each thing that can under these parameters.
void add_rules(std::vector<CodeLine>& lines, const CellPlace& place, const CellParameters& parameters, OnReenqueue on,
               int digits) {
    const auto add = [&](std::initializer_list<Rule> rules, std::string text, std::string_view source) -> CodeLine& {
        lines.push_back({std::move(text), 2, place.is(rules), {}, std::string(source)});
        return lines.back();
    };
    const auto keys = [&](CodeLine& line) {
        if (!line.lit || !place.facet->key) return;
        const Mark& before = place.facet->before;
        const double key = place.facet->key->key;
        const std::uint32_t n = place.facet->item.id;
        const int apart = std::max(digits, separating_digits(before.key, key));
        line.values = cell_and_key(n, key, digits);
        if (before.state != CellState::enqueued) return;
        line.values = "cell " + std::to_string(n) + ", key before " + short_number(before.key, apart) + ", key " +
                      short_number(key, apart);
    };
    constexpr std::string_view skip = "TVCG fig. 4, lines 7-8", key = "TVCG fig. 4, lines 9-10";
    add({Rule::border}, "no cell there: border of the tessellation", "");
    add({Rule::projected}, "n was projected before: leave it", skip);
    if (parameters.outside_view == OutsideView::unseen) {
        constexpr std::string_view unseen = "gem, add_neighbors_to_front";
        add({Rule::unseen}, "n was found outside the view before: leave it", unseen);
        add({Rule::marked_unseen}, "n is clean and outside the view: mark it unseen", unseen);
    }
    keys(add({Rule::enqueued}, "n is clean: put it into the front with key(n, c)", key));
    if (on == OnReenqueue::never) {
        keys(add({Rule::kept}, "n is in the front: it keeps its key", "gem, add_neighbors_to_front"));
    } else if (on == OnReenqueue::replace) {
        keys(add({Rule::reenqueued}, "n is in the front: key(n, c) and a new stamp replace its own", key));
    } else {
        const std::string order = on == OnReenqueue::min ? "lower" : "higher";
        keys(add({Rule::reenqueued}, "n is in the front, key(n, c) is " + order + ": it replaces its own", key));
        keys(add({Rule::kept}, "n is in the front, key(n, c) is not " + order + ": it keeps its own", ""));
    }
}

}  // namespace

template <int D>
std::vector<CodeLine> CellBase<D>::code(const CodePlace& at) const {
    const int digits = at.step ? digits_of(*at.step) : 3;
    const bool in_round = at.in_step() && at.step->item.kind == Kind::round;
    const CellPlace place =
        in_round ? CellPlace{}
                 : place_of(at, at.in_step() ? considered(*at.step, at.changes, digits) : std::vector<Considered>{});
    const bool neighbours_first = parameters_.neighbours_before_break == YesNo::yes;
    const Counters& counters = this->counters();
    std::vector<CodeLine> lines;
    lines.push_back({"while the front is not empty:",
                     0,
                     !place.in_step() && counters.spent < this->problem_.budget,
                     {},
                     "TVCG fig. 4, line 1"});
    if (!place.in_step())
        lines.back().values =
            std::to_string(counters.front_size) + (counters.front_size == 1 ? " cell in it" : " cells in it");
    lines.push_back({"take the cell c with the lowest key out of the front",
                     1,
                     place.at == CellPlace::At::pop,
                     {},
                     "TVCG fig. 4, line 2"});
    if (place.in_step()) {
        lines.back().values = cell_and_key(at.step->item.id, at.step->key, digits);
        if (at.step->runner_up)
            lines.back().values += "; next: " + cell_and_key(at.step->runner_up.id, at.step->runner_up_key, digits);
    }
    lines.push_back({std::string(project_line()),
                     1,
                     place.at == CellPlace::At::render,
                     {},
                     "TVCG fig. 4, line 3"});
    if (place.rendered())
        lines.back().values = std::to_string(at.rendered) + (at.rendered == 1 ? " primitive" : " primitives");
    if (parameters_.budget_counts == BudgetCounts::per_cell) {
        lines.push_back({"spend |c|, whether its primitives were rendered before or not",
                         1,
                         false,  // with the line above
                         {},
                         "gem, project"});
        if (place.rendered()) lines.back().values = std::to_string(this->problem_.cells->count(at.step->item.id));
    }
    const bool popping = place.at == CellPlace::At::pop;
    if (!neighbours_first) lines.push_back(budget_line(*this, 1, "", popping, place.in_step()));
    lines.push_back({"for each facet of c, with n the cell behind it:", 1, false, {}, "TVCG fig. 4, line 6"});
    if (place.facet) {
        lines.back().values =
            "facet " + std::to_string(place.facet_number) + " of " + std::to_string(place.facet_count);
        if (place.facet->item) lines.back().values += ", cell " + std::to_string(place.facet->item.id);
    }
    add_rules(lines, place, parameters_, reenqueue_rule(), digits);
    if (neighbours_first)
        lines.push_back(budget_line(*this, 1, ", after adding the neighbours", popping, place.in_step()));
    const KeyExplanation* key = place.facet && place.facet->key ? &*place.facet->key : nullptr;
    const std::size_t heading = lines.size();
    add_key_lines(lines, key, digits);
    if (key)
        lines[heading].values =
            "n = cell " + std::to_string(place.facet->item.id) + ", c = cell " + std::to_string(place.facet->from.id);
    if (rounds_) add_round_lines(lines, at, in_round);
    return lines;
}

template std::vector<CodeLine> CellBase<2>::code(const CodePlace&) const;
template std::vector<CodeLine> CellBase<3>::code(const CodePlace&) const;

}  // namespace sightline
