// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/pseudocode.h"

#include <algorithm>

#include "core/base/number.h"
#include "core/session/explain.h"

namespace sightline {

namespace {

/// Where in the last step: between two steps, at the pop, at the rendering, or at a facet of the cell.
struct Place {
    enum class At : std::uint8_t { between, pop, render, facet };
    At at = At::between;
    std::optional<FacetExplanation> facet;
    std::uint32_t facet_number = 0;  ///< from 1

    bool in_step() const { return at != At::between; }
    bool rendered() const { return at == At::render || at == At::facet; }
    bool is(std::initializer_list<Rule> rules) const {
        return facet && std::find(rules.begin(), rules.end(), facet->rule) != rules.end();
    }
};

Place place_of(const StepExplanation* step, std::optional<std::uint32_t> substep) {
    Place place;
    if (!step || !substep) return place;
    place.at = *substep == 0 ? Place::At::pop : *substep == 1 ? Place::At::render : Place::At::facet;
    if (*substep < 2) return place;
    place.facet = step->facets[*substep - 2];
    place.facet_number = *substep - 1;
    return place;
}

template <int D>
bool budget_used_up(const Session<D>& session) {
    return session.state().spent >= session.frame().budget;
}

template <int D>
CodeLine budget_line(const Session<D>& session, int indent, std::string_view more, const Place& place) {
    CodeLine line{"stop when the budget is used up" + std::string(more), indent, false, {}, "TVCG fig. 4, lines 4-5"};
    const std::uint32_t budget = session.frame().budget;
    if (place.at == Place::At::pop) return line;  // what the step will spend is not spent yet
    line.values = budget == none ? "no budget"
                                 : std::to_string(session.state().spent) + " of " + std::to_string(budget) + " spent";
    line.lit = !place.in_step() && budget_used_up(session);
    return line;
}

std::string cell_and_key(std::uint32_t cell, double key, int digits) {
    return "cell " + std::to_string(cell) + ", key " + short_number(key, digits);
}

std::string rendered_text(const StepExplanation& step) {
    return std::to_string(step.rendered) + (step.rendered == 1 ? " primitive" : " primitives");
}

/// What happens to the cell n behind a facet: one line for each thing that can under these settings.
template <int D>
void add_rules(std::vector<CodeLine>& lines, const Session<D>& session, const Place& place, int digits) {
    const auto add = [&](std::initializer_list<Rule> rules, std::string text, std::string_view source) -> CodeLine& {
        lines.push_back({std::move(text), 2, place.is(rules), {}, std::string(source)});
        return lines.back();
    };
    const auto keys = [&](CodeLine& line) {
        if (!line.lit || !place.facet->terms) return;
        const CellMark& before = place.facet->before;
        const double key = place.facet->terms->key;
        const int apart = std::max(digits, separating_digits(before.key, key));
        line.values = cell_and_key(place.facet->neighbour, key, digits);
        if (before.state != CellState::enqueued) return;
        line.values = "cell " + std::to_string(place.facet->neighbour) + ", key before " +
                      short_number(before.key, apart) + ", key " + short_number(key, apart);
    };
    const Settings& settings = session.settings();
    constexpr std::string_view skip = "TVCG fig. 4, lines 7-8", key = "TVCG fig. 4, lines 9-10";
    add({Rule::border}, "no cell there: it is the border", "");
    add({Rule::projected}, "n was projected before: leave it", skip);
    if (settings.outside_view == OutsideView::unseen) {
        constexpr std::string_view unseen = "gem, add_neighbors_to_front";
        add({Rule::unseen}, "n was found outside the view before: leave it", unseen);
        add({Rule::marked_unseen}, "n is clean and outside the view: mark it unseen", unseen);
    }
    keys(add({Rule::enqueued}, "n is clean: put it into the front with key(n, c)", key));
    if (!session.method().updates_enqueued) {
        keys(add({Rule::kept}, "n is in the front: it keeps its key", "gem, add_neighbors_to_front"));
    } else if (settings.on_reenqueue == OnReenqueue::replace) {
        keys(add({Rule::reenqueued}, "n is in the front: key(n, c) and a new stamp replace its own", key));
    } else {
        const std::string order = settings.on_reenqueue == OnReenqueue::min ? "lower" : "higher";
        keys(add({Rule::reenqueued}, "n is in the front, key(n, c) is " + order + ": it replaces its own", key));
        keys(add({Rule::kept}, "n is in the front, key(n, c) is not " + order + ": it keeps its own", ""));
    }
}

/// update_solidity: TVCG fig. 5.
template <int D>
void add_solidity(std::vector<CodeLine>& lines, const Session<D>& session, const Terms* terms, int digits) {
    const Settings& settings = session.settings();
    const auto add = [&](std::string text, const auto& values, std::string_view source) {
        lines.push_back({std::move(text), 1, false, terms ? values(*terms) : std::string(), std::string(source)});
    };
    const auto number = [&](double v) { return short_number(v, digits); };
    const bool p95 = settings.solidity_scale == SolidityScale::p95;
    add(
        p95 ? "crowd = |c| / ρ95, at most 1" : "crowd = |c| / ρ_max",
        [&](const Terms& t) {
            return std::to_string(t.count) + " / " + number(session.frame().solidity_scale) +
                   (t.count > session.frame().solidity_scale ? ", cut to " : " = ") + number(t.density);
        },
        "TVCG fig. 5, line 1");
    const TransferSign sign = settings.transfer_sign;
    add(
        sign == TransferSign::clamp ? "share = v · normal of the facet, at least 0"
        : sign == TransferSign::abs ? "share = |v · normal of the facet|"
                                    : "share = v · normal of the facet",
        [&](const Terms& t) {
            return number(t.alignment) + (t.weight == t.alignment ? "" : ", taken as " + number(t.weight));
        },
        "TVCG fig. 5, line 1");
    add(
        "ρ = crowd + share · ρ of c", [&](const Terms& t) { return formula_sum(t, digits); }, "TVCG fig. 5, line 1");
    if (settings.star_shaped == Switch::on && settings.penalty != Penalty::none) {
        add(
            "the ray from the eye to the centre of n misses the facet?",
            [&](const Terms& t) { return std::string(t.star_shaped ? "no: star-shaped" : "yes: not star-shaped"); },
            "TVCG fig. 5, line 2");
        add((settings.penalty == Penalty::multiply ? "then ρ = ρ × " : "then ρ = ρ + ") +
                number(settings.penalty_amount),
            [&](const Terms& t) {
                return t.penalised() ? number(t.unpenalised) + " " + formula_penalty(t, settings, digits)
                                     : std::string();
            },
            "TVCG fig. 5, line 3");
        lines.back().indent = 2;
    }
    add(
        "the key is ρ", [&](const Terms& t) { return number(t.key); }, "TVCG fig. 5, line 4");
}

template <int D>
void add_key(std::vector<CodeLine>& lines, const Session<D>& session, const Place& place, int digits) {
    const Terms* terms = place.facet && place.facet->terms ? &*place.facet->terms : nullptr;
    const std::string_view method = session.method().id;
    const bool published = method == "published", layers = method == "layers";
    lines.push_back({"key(n, c): " + (published ? "the solidity ρ that c hands on to n"
                                      : layers  ? "the layer of n, behind c"
                                                : "as " + std::string(session.method().title) + " has it"),
                     0,
                     false,
                     {},
                     {}});
    if (terms)
        lines.back().values =
            "n = cell " + std::to_string(place.facet->neighbour) + ", c = cell " + std::to_string(place.facet->from);
    if (published) return add_solidity(lines, session, terms, digits);
    const auto number = [&](double v) { return short_number(v, digits); };
    if (layers) {
        lines.push_back({"the layer of c + 1", 1, false, {}, "gem, add_neighbors_to_front"});
        if (terms) lines.back().values = number(terms->rho_a) + " + 1 = " + number(terms->key);
        return;
    }
    // The terms are all that is known of a method from another table.
    lines.push_back({"its density + its weight · key of c, and its penalty if any", 1, false, {}, {}});
    if (terms) lines.back().values = formula(*terms, session.settings(), digits);
}

template <int D>
std::vector<CodeLine> cell_lines(const Session<D>& session, const StepExplanation* step, const Place& place) {
    const int digits = step ? step->digits() : 3;
    const bool neighbours_first = session.settings().neighbours_before_break == YesNo::yes;
    std::vector<CodeLine> lines;
    lines.push_back(
        {"while the front is not empty:", 0, !place.in_step() && !budget_used_up(session), {}, "TVCG fig. 4, line 1"});
    if (!place.in_step()) {
        const std::uint32_t size = session.state().front_size;
        lines.back().values = std::to_string(size) + (size == 1 ? " cell in it" : " cells in it");
    }
    lines.push_back({"take the cell c with the lowest key out of the front",
                     1,
                     place.at == Place::At::pop,
                     {},
                     "TVCG fig. 4, line 2"});
    if (place.in_step()) {
        lines.back().values = cell_and_key(step->cell, step->key, digits);
        if (step->runner_up != none)
            lines.back().values += "; next: " + cell_and_key(step->runner_up, step->runner_up_key, digits);
    }
    lines.push_back({"project c: render its primitives in view that are not rendered yet",
                     1,
                     place.at == Place::At::render,
                     {},
                     "TVCG fig. 4, line 3"});
    if (place.rendered()) lines.back().values = rendered_text(*step);
    if (!neighbours_first) lines.push_back(budget_line(session, 1, "", place));
    lines.push_back({"for each facet of c, n being the cell behind it:", 1, false, {}, "TVCG fig. 4, line 6"});
    if (place.facet) {
        lines.back().values =
            "facet " + std::to_string(place.facet_number) + " of " + std::to_string(step->facets.size());
        if (place.facet->neighbour != none) lines.back().values += ", cell " + std::to_string(place.facet->neighbour);
    }
    add_rules(lines, session, place, digits);
    if (neighbours_first) lines.push_back(budget_line(session, 1, ", neighbours added", place));
    add_key(lines, session, place, digits);
    return lines;
}

template <int D>
std::vector<CodeLine> primitive_lines(const Session<D>& session, const StepExplanation* step, const Place& place) {
    const std::string_view method = session.method().id;
    const State<D>& state = session.state();
    std::vector<CodeLine> lines;
    if (method == "centroid")
        lines.push_back({"order the primitives, nearest centroid first", 0, false, {}, "TVCG section 4.5"});
    else if (method == "view" || method == "everything")
        lines.push_back({"order the primitives as the scene has them", 0, false, {}, {}});
    else
        lines.push_back(
            {"order the primitives as " + std::string(session.method().title) + " has it", 0, false, {}, {}});
    lines.back().values = std::to_string(state.order.size()) + " primitives";
    lines.push_back({"while some are left:", 0, !place.in_step() && !budget_used_up(session), {}, {}});
    if (!place.in_step()) lines.back().values = std::to_string(state.order.size() - state.offset) + " left";
    lines.push_back({"take the next " + std::to_string(primitive_batch), 1, place.at == Place::At::pop, {}, {}});
    if (place.in_step())
        lines.back().values =
            "from number " + std::to_string(std::size_t{step->step - 1} * primitive_batch + 1) + " of the order";
    lines.push_back({method == "everything"                     ? "render them"
                     : method == "view" || method == "centroid" ? "render those in view"
                                                                : "render those that the method does not cull",
                     1,
                     place.at == Place::At::render,
                     {},
                     {}});
    if (place.rendered()) lines.back().values = rendered_text(*step);
    lines.push_back(budget_line(session, 1, "", place));
    lines.back().source.clear();
    return lines;
}

}  // namespace

template <int D>
std::vector<CodeLine> pseudocode(const Session<D>& session, std::optional<std::uint32_t> substep) {
    std::optional<StepExplanation> step;
    if (session.position() > 0) step = explain_step(session, session.position());
    const Place place = place_of(step ? &*step : nullptr, substep);
    return session.method().orders_cells ? cell_lines(session, step ? &*step : nullptr, place)
                                         : primitive_lines(session, step ? &*step : nullptr, place);
}

template std::vector<CodeLine> pseudocode<2>(const Session<2>&, std::optional<std::uint32_t>);
template std::vector<CodeLine> pseudocode<3>(const Session<3>&, std::optional<std::uint32_t>);

}  // namespace sightline
