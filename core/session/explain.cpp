// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain.h"

#include <algorithm>
#include <map>

#include "core/number.h"

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

/// For every cell the update that set the key in force at the position: step and index of the facet.
template <int D>
std::map<std::uint32_t, std::pair<std::uint32_t, std::size_t>> updates_in_force(const Session<D>& session) {
    std::map<std::uint32_t, std::pair<std::uint32_t, std::size_t>> updates;
    for (std::uint32_t step = 1; step <= session.position(); ++step) {
        const std::uint32_t cell = session.timeline().steps[step - 1].cell;
        if (cell == none) continue;
        const auto records = session.timeline().facets_of(step);
        const auto facets = session.cells().facets_of(cell);
        for (std::size_t i = 0; i < records.size(); ++i)
            if (records[i].rule == Rule::enqueued || records[i].rule == Rule::reenqueued)
                updates[facets[i].neighbour] = {step, i};
    }
    return updates;
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
    std::uint32_t best = none, best_rank = 0, unseen = 0, neighbours = 0;
    for (const HalfFacet& half : session.cells().facets_of(cell)) {
        if (half.neighbour == none) continue;
        ++neighbours;
        unseen += session.state().mark(half.neighbour).state == CellState::unseen;
        const std::uint32_t rank = rank_in_front(session, half.neighbour);
        if (rank > 0 && (best == none || rank < best_rank)) {
            best = half.neighbour;
            best_rank = rank;
        }
    }
    if (!session.method().orders_cells) return "the method orders primitives, not cells";
    if (best != none)
        return "no neighbour is projected yet; the first will be " + cell_name(best) + ", number " +
               std::to_string(best_rank) + " in the front";
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

std::string formula(const Terms& t, const Settings& settings, int digits) {
    const auto number = [&](double v) { return short_number(v, digits); };
    std::string text =
        "ρ = " + number(t.density) + " + " + number(t.weight) + " · " + number(t.rho_a) + " = " + number(t.unpenalised);
    if (t.penalised())
        text += std::string(settings.penalty == Penalty::multiply ? ", × " : ", + ") + number(settings.penalty_amount) +
                " (not star-shaped) = " + number(t.key);
    return text;
}

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
    for (const FacetExplanation& facet : step.facets) {
        if (facet.neighbour == none) {
            text.push_back("  border: no neighbour");
            continue;
        }
        std::string row =
            "  " + cell_name(facet.neighbour) + ": " + std::string(rule_words[static_cast<std::size_t>(facet.rule)]);
        if (facet.terms) row += ", " + formula(*facet.terms, settings);
        if (facet.rule == Rule::reenqueued || facet.rule == Rule::kept) {
            const double now = facet.rule == Rule::kept ? facet.before.key : facet.terms->key;
            const int digits = separating_digits(facet.before.key, now);
            row += " (key before " + short_number(facet.before.key, digits) +
                   (facet.rule == Rule::kept ? ", stays)" : ", now " + short_number(now, digits) + ")");
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
        const int digits = step.runner_up == none ? 3 : separating_digits(step.key, step.runner_up_key);
        text += cell_name(step.cell) + " has the lowest key, " + short_number(step.key, digits);
        if (step.runner_up == none)
            text += ", and was alone in the front";
        else if (step.runner_up_key == step.key)
            text += "; " + cell_name(step.runner_up) + " has the same: a tie, the older stamp wins";
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
CellExplanation explain_cell(const Session<D>& session, std::uint32_t cell) {
    CellExplanation e;
    e.cell = cell;
    e.mark = session.state().mark(cell);
    e.visible_share = session.reference().cell_share[cell];
    for (std::uint32_t step = 1; step <= session.position(); ++step)
        if (session.timeline().steps[step - 1].cell == cell) e.projected_at = step;
    e.rank = rank_in_front(session, cell);
    const auto updates = updates_in_force(session);
    for (auto update = updates.find(cell); update != updates.end();) {
        const auto [step, index] = update->second;
        const std::uint32_t from = session.timeline().steps[step - 1].cell;
        e.chain.push_back({step, explain_facet(session, from, index, session.timeline().facets_of(step)[index])});
        update = updates.find(from);
    }
    std::reverse(e.chain.begin(), e.chain.end());
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
        head += ", key " + short_number(cell.mark.key);
    if (cell.rank > 0) head += ", number " + std::to_string(cell.rank) + " in the front";
    head += cell.visible_share > 0 ? ", holds " + percent(cell.visible_share) + " of what is visible" : ", hidden";
    text.push_back(head + ".");
    if (!cell.held_back_by.empty())
        text.push_back((cell.rank > 0 ? "  held back by: " : "  not in the front: ") + cell.held_back_by + ".");
    for (const ChainLink& link : cell.chain)
        text.push_back("  step " + std::to_string(link.step) + ": " + cell_name(link.update.from) + " -> " +
                       cell_name(link.update.neighbour) + ", " + formula(*link.update.terms, settings));
    return text;
}

template StepExplanation explain_step<2>(const Session<2>&, std::uint32_t);
template CellExplanation explain_cell<2>(const Session<2>&, std::uint32_t);

}  // namespace sightline
