// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain.h"

#include <algorithm>

#include "core/base/number.h"

namespace sightline {

namespace {

std::string cell_name(std::uint32_t cell) { return "cell " + std::to_string(cell); }

template <int D>
FacetExplanation explain_facet(const Session<D>& session, std::uint32_t cell, std::size_t index,
                               const FacetRecord& record) {
    const HalfFacet& half = session.cells().facets_of(cell)[index];
    FacetExplanation e{cell, half.neighbour, half.facet(), record.rule, {record.key, record.stamp, record.state}, {}};
    if (session.method().terms &&
        (record.rule == Rule::enqueued || record.rule == Rule::reenqueued || record.rule == Rule::kept))
        e.terms = session.method().terms(session.frame(), cell, session.state().mark(cell).key, half);
    return e;
}

/// The part of a key that weighs most, for people.
std::string heaviest_term(const Terms& t) {
    const double transferred = t.weight * t.rho_a, penalty = t.key - t.unpenalised;
    if (penalty > t.density && penalty > transferred)
        return "the penalty (+" + short_number(penalty) + "): the ray from the eye to its centre misses the facet";
    if (t.density > 0 && t.count == 0)
        return "its way from the seed: " + short_number(t.key) + (t.key == 1 ? " facet" : " facets");
    if (transferred > t.density)
        return "the solidity handed on by the cell in front of it (" + short_number(transferred) + ")";
    if (t.density > 0) return "the crowd in the cell in front of it (|A| = " + std::to_string(t.count) + ")";
    return "nothing but its stamp: its key is 0";
}

/// Per cell the step, up to the position, that projected it; 0: none.
template <int D>
std::vector<std::uint32_t> steps_of_projection(const Session<D>& session) {
    std::vector<std::uint32_t> steps(session.cells().cell_count(), 0);
    for (std::uint32_t step = 1; step <= std::min(session.position(), session.recorded()); ++step)
        if (const std::uint32_t cell = session.timeline().steps[step - 1].cell; cell != none) steps[cell] = step;
    return steps;
}

/// A facet that a cell was reached through: the step, and the facet's place in the row of the cell of that step.
struct Reach {
    std::uint32_t step;
    std::uint32_t index;
    auto operator<=>(const Reach&) const = default;
};

/// Every facet across which a key was computed for the cell, in the order of steps. `projected_at` is
/// steps_of_projection.
template <int D>
std::vector<Reach> reaches(const Session<D>& session, std::uint32_t cell,
                           const std::vector<std::uint32_t>& projected_at) {
    std::vector<Reach> found;
    for (const HalfFacet& own : session.cells().facets_of(cell)) {
        const std::uint32_t step = own.neighbour == none ? 0 : projected_at[own.neighbour];
        if (step == 0) continue;
        const auto facets = session.cells().facets_of(own.neighbour);
        const auto records = session.timeline().facets_of(step);
        for (std::uint32_t i = 0; i < records.size(); ++i)
            if (facets[i].facet() == own.facet() &&
                (records[i].rule == Rule::enqueued || records[i].rule == Rule::reenqueued ||
                 records[i].rule == Rule::kept))
                found.push_back({step, i});
    }
    std::sort(found.begin(), found.end());
    return found;
}

template <int D>
ChainLink link(const Session<D>& session, const Reach& reach) {
    const std::uint32_t from = session.timeline().steps[reach.step - 1].cell;
    const FacetRecord& record = session.timeline().facets_of(reach.step)[reach.index];
    return {reach.step, explain_facet(session, from, reach.index, record)};
}

/// Back to the seed: what a cell was last given by is what its key comes from. `reached` is reaches() of the cell.
template <int D>
std::vector<ChainLink> chain_of(const Session<D>& session, std::vector<Reach> reached,
                                const std::vector<std::uint32_t>& projected_at) {
    std::vector<ChainLink> chain;
    for (;;) {
        while (!reached.empty() &&
               session.timeline().facets_of(reached.back().step)[reached.back().index].rule == Rule::kept)
            reached.pop_back();
        if (reached.empty()) break;
        chain.push_back(link(session, reached.back()));
        reached = reaches(session, chain.back().update.from, projected_at);
    }
    std::reverse(chain.begin(), chain.end());
    return chain;
}

template <int D>
std::uint32_t rank_in_front(const Session<D>& session, std::uint32_t cell) {
    const CellMark mark = session.state().mark(cell);
    if (mark.state != CellState::enqueued) return 0;
    std::uint32_t rank = 1;
    for (std::uint32_t other = 0; other < session.cells().cell_count(); ++other) {
        const CellMark m = session.state().mark(other);
        rank += m.state == CellState::enqueued && (m.key < mark.key || (m.key == mark.key && m.stamp < mark.stamp));
    }
    return rank;
}

template <int D>
std::string what_keeps_it_out(const Session<D>& session, std::uint32_t cell) {
    if (session.state().mark(cell).state == CellState::unseen) return "it lies outside the view";
    std::optional<Front::Entry> best;
    std::uint32_t unseen = 0, neighbours = 0;
    for (const HalfFacet& half : session.cells().facets_of(cell)) {
        if (half.neighbour == none) continue;
        ++neighbours;
        const CellMark mark = session.state().mark(half.neighbour);
        unseen += mark.state == CellState::unseen;
        const Front::Entry entry{mark.key, mark.stamp, half.neighbour};
        if (mark.state == CellState::enqueued && (!best || entry.before(*best))) best = entry;
    }
    if (!session.method().orders_cells) return "the method orders primitives, not cells";
    if (best)
        return "no neighbour is projected yet; the first will be " + cell_name(best->cell) + ", number " +
               std::to_string(rank_in_front(session, best->cell)) + " in the front";
    if (unseen == neighbours) return "all its neighbours lie outside the view";
    if (session.state().partial_cell != none)
        return "the budget ended before the neighbours of the last cell were added";
    return "the front has not come near: none of its neighbours is in it";
}

std::string percent(double share) { return short_number(share * 100) + " %"; }

}  // namespace

int separating_digits(double a, double b) {
    if (a == b) return 3;
    for (int digits = 3; digits < 17; ++digits)
        if (short_number(a, digits) != short_number(b, digits)) return digits;
    return 17;
}

std::string formula_sum(const Terms& t, int digits) {
    return short_number(t.density, digits) + " + " + short_number(t.weight, digits) + " · " +
           short_number(t.rho_a, digits) + " = " + short_number(t.unpenalised, digits);
}

std::string formula_penalty(const Terms& t, const Settings& settings, int digits) {
    return (settings.penalty == Penalty::multiply ? "× " : "+ ") + short_number(settings.penalty_amount, digits) +
           " (not star-shaped) = " + short_number(t.key, digits);
}

std::string formula(const Terms& t, const Settings& settings, int digits) {
    std::string text = "ρ = " + formula_sum(t, digits);
    if (t.penalised()) text += ", " + formula_penalty(t, settings, digits);
    return text;
}

int StepExplanation::digits() const { return runner_up == none ? 3 : separating_digits(key, runner_up_key); }

template <int D>
StepExplanation explain_step(const Session<D>& session, std::uint32_t step) {
    const StepRecord& record = session.timeline().steps[step - 1];
    StepExplanation e;
    e.step = step;
    e.cell = record.cell;
    e.runner_up = record.runner_up;
    e.runner_up_key = record.runner_up_key;
    const std::uint32_t before = session.timeline().touched_before(step);
    e.rendered = record.rendered_count - session.timeline().rendered_before(step);
    e.visible = static_cast<std::uint32_t>(visible_rendered<D>(
        session.reference(), std::span(session.state().touched).subspan(before, record.touched_count - before)));
    if (record.cell == none) return e;
    const CellMark mark = session.state().mark(record.cell);
    e.key = mark.key;
    e.stamp = mark.stamp;
    e.visible_share = session.reference().cell_share[record.cell];
    const auto records = session.timeline().facets_of(step);
    for (std::size_t i = 0; i < records.size(); ++i)
        e.facets.push_back(explain_facet(session, record.cell, i, records[i]));
    return e;
}

std::vector<std::string> rows(const StepExplanation& step, const Settings& settings) {
    std::vector<std::string> text{sentence(step)};
    const int digits = step.digits();
    for (const FacetExplanation& facet : step.facets) {
        if (facet.neighbour == none) {
            text.push_back("  border: no neighbour");
            continue;
        }
        std::string row =
            "  " + cell_name(facet.neighbour) + ": " + std::string(rule_words[static_cast<std::size_t>(facet.rule)]);
        if (facet.terms) row += ", " + formula(*facet.terms, settings, digits);
        if (facet.rule == Rule::reenqueued || facet.rule == Rule::kept) {
            const double now = facet.rule == Rule::kept ? facet.before.key : facet.terms->key;
            const int apart = std::max(digits, separating_digits(facet.before.key, now));
            row += " (key before " + short_number(facet.before.key, apart) +
                   (facet.rule == Rule::kept ? ", stays)" : ", now " + short_number(now, apart) + ")");
        }
        text.push_back(row);
    }
    return text;
}

std::string sentence(const StepExplanation& step) {
    std::string text = "Step " + std::to_string(step.step) + ": ";
    if (step.cell == none) {
        text += "a batch of primitives in the method's order";
    } else {
        const int digits = step.digits();
        text += cell_name(step.cell) + " has the lowest key, " + short_number(step.key, digits);
        if (step.runner_up == none)
            text += ", and was alone in the front";
        else if (step.runner_up_key == step.key)
            text += "; " + cell_name(step.runner_up) + " has the same: tie, older stamp wins";
        else
            text +=
                "; the runner-up is " + cell_name(step.runner_up) + " with " + short_number(step.runner_up_key, digits);
    }
    text += "; it rendered " + std::to_string(step.rendered) + (step.rendered == 1 ? " primitive" : " primitives");
    if (step.rendered > 0) text += ", " + std::to_string(step.visible) + " of them visible";
    if (step.cell != none)
        text += step.visible_share > 0 ? "; it holds " + percent(step.visible_share) + " of what is visible"
                                       : "; nothing in it is visible";
    return text + ".";
}

template <int D>
std::vector<ChainLink> update_chain(const Session<D>& session, std::uint32_t cell) {
    const std::vector<std::uint32_t> projected_at = steps_of_projection(session);
    return chain_of(session, reaches(session, cell, projected_at), projected_at);
}

template <int D>
CellExplanation explain_cell(const Session<D>& session, std::uint32_t cell) {
    CellExplanation e;
    e.cell = cell;
    e.mark = session.state().mark(cell);
    e.visible_share = session.reference().cell_share[cell];
    e.rank = rank_in_front(session, cell);
    if (session.position() > 0) {
        const StepRecord& last = session.timeline().steps[session.position() - 1];
        if (last.runner_up != none)
            e.digits = separating_digits(session.state().mark(last.cell).key, last.runner_up_key);
    }
    const std::vector<std::uint32_t> projected_at = steps_of_projection(session);
    e.projected_at = projected_at[cell];
    std::vector<Reach> reached = reaches(session, cell, projected_at);
    for (const Reach& reach : reached) e.reached.push_back(link(session, reach));
    e.chain = chain_of(session, std::move(reached), projected_at);
    if (e.mark.state == CellState::enqueued)
        e.held_back_by = e.chain.empty() ? "nothing: it is a seed" : heaviest_term(*e.chain.back().update.terms);
    else if (e.mark.state != CellState::projected)
        e.held_back_by = what_keeps_it_out(session, cell);
    return e;
}

std::vector<std::string> rows(const CellExplanation& cell, const Settings& settings) {
    std::vector<std::string> text;
    std::string head = "Cell " + std::to_string(cell.cell) + ": " +
                       std::string(cell_state_words[static_cast<std::size_t>(cell.mark.state)]);
    if (cell.projected_at > 0) head += " in step " + std::to_string(cell.projected_at);
    if (cell.mark.state == CellState::projected || cell.mark.state == CellState::enqueued)
        head += ", key " + short_number(cell.mark.key, cell.digits);
    if (cell.rank > 0) head += ", number " + std::to_string(cell.rank) + " in the front";
    head += cell.visible_share > 0 ? ", holds " + percent(cell.visible_share) + " of what is visible" : ", hidden";
    text.push_back(head + ".");
    if (!cell.held_back_by.empty())
        text.push_back((cell.rank > 0 ? "  held back by: " : "  not in the front: ") + cell.held_back_by + ".");
    const auto add = [&](const ChainLink& link, const char* indent, const std::string& what) {
        text.push_back(indent + ("step " + std::to_string(link.step)) + ": " + cell_name(link.update.from) + " -> " +
                       cell_name(link.update.neighbour) + ", " + what +
                       formula(*link.update.terms, settings, cell.digits));
    };
    for (const ChainLink& link : cell.chain) add(link, "  ", "");
    if (cell.reached.size() > 1) {  // the chain ends with one of them
        text.push_back("  reached through " + std::to_string(cell.reached.size()) + " facets:");
        for (const ChainLink& link : cell.reached)
            add(link, "    ", std::string(rule_words[static_cast<std::size_t>(link.update.rule)]) + ", ");
    }
    return text;
}

template <int D>
std::vector<Front::Entry> front_entries(const Session<D>& session) {
    std::vector<Front::Entry> entries;
    entries.reserve(session.state().front_size);
    for (std::uint32_t cell = 0; cell < session.cells().cell_count(); ++cell)
        if (const CellMark mark = session.state().mark(cell); mark.state == CellState::enqueued)
            entries.push_back({mark.key, mark.stamp, cell});
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.before(b); });
    return entries;
}

template StepExplanation explain_step<2>(const Session<2>&, std::uint32_t);
template StepExplanation explain_step<3>(const Session<3>&, std::uint32_t);
template std::vector<ChainLink> update_chain<2>(const Session<2>&, std::uint32_t);
template std::vector<ChainLink> update_chain<3>(const Session<3>&, std::uint32_t);
template CellExplanation explain_cell<2>(const Session<2>&, std::uint32_t);
template CellExplanation explain_cell<3>(const Session<3>&, std::uint32_t);
template std::vector<Front::Entry> front_entries<2>(const Session<2>&);
template std::vector<Front::Entry> front_entries<3>(const Session<3>&);

}  // namespace sightline
