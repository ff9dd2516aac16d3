// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/explain.h"

#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/methods/cells/cell_parameters.h"
#include "core/methods/cells/cell_rules.h"

namespace sightline {

template <int D>
std::vector<std::uint32_t> steps_of_projection(const Session<D>& session) {
    std::vector<std::uint32_t> steps(session.cells().cell_count(), 0);
    for (std::uint32_t step = 1; step <= std::min(session.position(), session.recorded()); ++step)
        if (const Item item = session.timeline().steps[step - 1].item; item.kind == Kind::cell)
            steps[item.id] = step;
        else if (item.kind == Kind::round)
            for (const Change& change : session.timeline().changes_of(step))
                if (Rule{change.rule} == Rule::projected_now) steps[change.id] = step;
    return steps;
}

namespace {

std::string cell_name(std::uint32_t cell) { return item_name(cell_item(cell)); }

/// A facet that a cell was reached through: the step, and the change's place among those of the step.
struct Reach {
    std::uint32_t step;
    std::uint32_t index;
    auto operator<=>(const Reach&) const = default;
};

bool computes_key(const Change& change) {
    const Rule rule{change.rule};
    return rule == Rule::enqueued || rule == Rule::reenqueued || rule == Rule::kept;
}

/// Every facet across which a key was computed for the cell, in the order of steps. `projected_at` is
/// steps_of_projection.
template <int D>
std::vector<Reach> reaches(const Session<D>& session, std::uint32_t cell,
                           const std::vector<std::uint32_t>& projected_at) {
    std::vector<Reach> found;
    for (const HalfFacet& own : session.cells().facets_of(cell)) {
        const std::uint32_t step = own.neighbour == none ? 0 : projected_at[own.neighbour];
        if (step == 0) continue;
        const auto changes = session.timeline().changes_of(step);
        for (std::uint32_t i = 0; i < changes.size(); ++i)
            if (changes[i].item() == cell_item(cell) && changes[i].via == own.facet() && computes_key(changes[i]))
                found.push_back({step, i});
    }
    std::sort(found.begin(), found.end());
    return found;
}

template <int D>
ChainLink link(const Session<D>& session, const Reach& reach, int digits) {
    const Change& change = session.timeline().changes_of(reach.step)[reach.index];
    for (Considered& c : session.traversal().considered(session.timeline().steps[reach.step - 1],
                                                        session.timeline().changes_of(reach.step), digits))
        if (c.item == change.item() && c.via.id == change.via) return {reach.step, std::move(c)};
    return {reach.step, {}};
}

/// Of reaches(), those up to the one whose key is in force.
template <int D>
void drop_kept(const Session<D>& session, std::vector<Reach>& reached) {
    while (!reached.empty() &&
           Rule{session.timeline().changes_of(reached.back().step)[reached.back().index].rule} == Rule::kept)
        reached.pop_back();
}

/// Back to the seed: what a cell was last given by is what its key comes from. `reached` is reaches() of the cell.
template <int D>
std::vector<ChainLink> chain_of(const Session<D>& session, std::vector<Reach> reached,
                                const std::vector<std::uint32_t>& projected_at, int digits) {
    std::vector<ChainLink> chain;
    for (;;) {
        drop_kept(session, reached);
        if (reached.empty()) break;
        chain.push_back(link(session, reached.back(), digits));
        reached = reaches(session, chain.back().update.from.id, projected_at);
    }
    std::reverse(chain.begin(), chain.end());
    return chain;
}

}  // namespace

template <int D>
std::uint32_t rank_in_front(const Session<D>& session, std::uint32_t cell) {
    const Mark mark = session.mark(cell);
    if (mark.state != CellState::enqueued) return 0;
    std::uint32_t rank = 1;
    for (std::uint32_t other = 0; other < session.cells().cell_count(); ++other) {
        const Mark m = session.mark(other);
        rank += m.state == CellState::enqueued && comes_before(m, mark);
    }
    return rank;
}

std::string key_before(const Considered& c, int digits) {
    if (!c.key || c.before.state != CellState::enqueued) return {};
    const bool stays = c.effect == Effect::kept;
    const double now = stays ? c.before.key : c.key->key;
    const int apart = std::max(digits, separating_digits(c.before.key, now));
    return "key before " + short_number(c.before.key, apart) +
           (stays ? ", stays" : ", now " + short_number(now, apart));
}

template <int D>
StepExplanation explain_step(const Session<D>& session, std::uint32_t step) {
    const Timeline<D>& timeline = session.timeline();
    const Step& record = timeline.steps[step - 1];
    StepExplanation e;
    e.step = step;
    e.item = record.item;
    e.cell = id_of(record.item, Kind::cell);
    e.words = session.traversal().popped_words(record);
    e.key = record.key;
    if (const auto key = session.traversal().key_terms(record.item, digits_of(record))) e.formula = key->formula();
    e.stamp = record.stamp;
    e.runner_up = id_of(record.runner_up, Kind::cell);
    e.runner_up_key = record.runner_up_key;
    e.digits = digits_of(record);
    const Counters &before = timeline.before(step), &after = timeline.after(step);
    e.rendered = after.rendered_count - before.rendered_count;
    e.stood_in = after.stood_in - before.stood_in;
    e.visible = static_cast<std::uint32_t>(
        visible_rendered(session.reference(), timeline.met_in(step, session.traversal().drawn().all())));
    if (e.cell != none) e.visible_share = session.reference().cell_share[e.cell];
    e.looked_at = session.traversal().considered(record, timeline.changes_of(step), e.digits);
    return e;
}

std::vector<std::string> rows(const StepExplanation& step) {
    std::vector<std::string> text{sentence(step)};
    for (const Considered& c : step.looked_at) {
        if (!c.item) {
            text.push_back("  border: no neighbour");
            continue;
        }
        std::string row = "  " + item_name(c.item) + ": " + std::string(c.words);
        if (c.key) row += ", " + c.key->formula();
        if (const std::string keys = key_before(c, step.digits); !keys.empty()) row += " (" + keys + ")";
        text.push_back(row);
    }
    return text;
}

std::string share_words(double visible_share, std::uint32_t visible) {
    if (visible_share > 0) return percent_text(visible_share) + " of what is visible lies inside the cell";
    if (visible == 0) return "nothing visible lies inside the cell";
    return std::string(visible == 1 ? "its" : "their") + " visible part lies outside this cell";
}

std::string sentence(const StepExplanation& step) {
    std::string text = "Step " + std::to_string(step.step) + ": ";
    if (step.cell == none) {
        text += step.words + (step.formula.empty() ? "" : ", " + step.formula);
    } else {
        text += cell_name(step.cell) + " has the lowest key, " + short_number(step.key, step.digits);
        if (step.runner_up == none)
            text += ", and was alone in the front";
        else if (step.runner_up_key == step.key)
            text += "; " + cell_name(step.runner_up) + " has the same: tie, older stamp wins";
        else
            text += "; the runner-up is " + cell_name(step.runner_up) + " with " +
                    short_number(step.runner_up_key, step.digits);
    }
    if (step.stood_in > 0) return text + ".";  // what it says of the level is all that it drew
    text += "; it rendered " + std::to_string(step.rendered) + (step.rendered == 1 ? " primitive" : " primitives");
    if (step.rendered > 0) text += ", " + std::to_string(step.visible) + " of them visible";
    if (step.cell != none) text += "; " + share_words(step.visible_share, step.visible);
    return text + ".";
}

template <int D>
std::vector<ChainLink> update_chain(const Session<D>& session, std::uint32_t cell) {
    const std::vector<std::uint32_t> projected_at = steps_of_projection(session);
    return chain_of(session, reaches(session, cell, projected_at), projected_at, 3);
}

template <int D>
std::optional<ChainLink> key_source(const Session<D>& session, std::uint32_t cell, int digits) {
    std::vector<Reach> reached = reaches(session, cell, steps_of_projection(session));
    drop_kept(session, reached);
    if (reached.empty()) return std::nullopt;
    return link(session, reached.back(), digits);
}

/// The lowest key that was computed for a cell in the front and is not its key.
template <int D>
std::optional<LostKey> lost_key(const Session<D>& session, const CellExplanation& e) {
    const ChainLink* best = nullptr;
    for (const ChainLink& link : e.reached)
        if (link.update.key->key < e.mark.key && (!best || link.update.key->key < best->update.key->key)) best = &link;
    if (!best) return std::nullopt;
    LostKey lost{best->update.key->key, best->step, best->update.before.key, best->step, false, {}};
    if (best->update.effect != Effect::kept) {  // the next update threw it away
        const ChainLink* next = best + 1;
        while (next->update.effect == Effect::kept) ++next;
        lost.taken = true;
        lost.instead = next->update.key->key;
        lost.lost_in = next->step;
    }
    if (const ParameterRow* row = session.method().parameter(on_reenqueue_row().name))
        lost.with_min = outcome_with(session, cell_item(e.cell), *row, word(OnReenqueue::min));
    return lost;
}

std::string lost_words(const LostKey& lost, std::string_view rule) {
    const int digits = separating_digits(lost.key, lost.instead);
    const std::string key = short_number(lost.key, digits), instead = short_number(lost.instead, digits);
    std::string text =
        rule.empty() ? "the method's rule for cells reached again: " : "on_reenqueue=" + std::string(rule) + ": ";
    text += lost.taken
                ? "its key " + key + " from step " + std::to_string(lost.step) + " was replaced by " + instead +
                      " in step " + std::to_string(lost.lost_in)
                : "the key " + key + " from step " + std::to_string(lost.step) + " was not taken; it kept " + instead;
    if (!lost.with_min) return text;
    const Outcome& min = *lost.with_min;
    if (min.step > 0)
        return text + "; with on_reenqueue=min it would have been projected in step " + std::to_string(min.step);
    return text + "; with on_reenqueue=min it would not have been projected either";
}

/// Of a cell in the front.
template <int D>
Verdict why_waiting(const Session<D>& session, CellExplanation& e) {
    if (e.rank == 1)
        return {"first", session.finished() ? "the budget: it is first in the front" : "nothing: it comes next"};
    e.lost = lost_key(session, e);
    if (e.lost) {
        const ParameterRow* row = session.method().parameter(on_reenqueue_row().name);
        return {"lost-key", lost_words(*e.lost, row ? session.problem().parameters.text(*row) : std::string_view())};
    }
    if (e.chain.empty()) return {"seed", "its stamp: it is a seed, and others come before it"};
    return {"key", e.chain.back().update.key->weightiest};
}

template <int D>
CellExplanation explain_cell(const Session<D>& session, std::uint32_t cell) {
    CellExplanation e;
    e.cell = cell;
    e.mark = session.mark(cell);
    e.visible_share = session.reference().cell_share[cell];
    e.rank = rank_in_front(session, cell);
    if (session.position() > 0) e.digits = digits_of(session.timeline().steps[session.position() - 1]);
    const std::vector<std::uint32_t> projected_at = steps_of_projection(session);
    e.projected_at = projected_at[cell];
    std::vector<Reach> reached = reaches(session, cell, projected_at);
    for (const Reach& reach : reached) e.reached.push_back(link(session, reach, e.digits));
    e.chain = chain_of(session, std::move(reached), projected_at, e.digits);
    if (e.mark.state == CellState::enqueued) {
        e.verdict = session.traversal().why_waiting(cell_item(cell));
        if (!e.verdict) e.verdict = why_waiting(session, e);
    } else {
        e.verdict = session.traversal().why_not(cell_item(cell));
    }
    return e;
}

std::string_view verdict_title(const CellExplanation& cell) {
    return cell.rank > 0 ? "held back by" : "not in the front";
}

std::vector<ChainPart> chain_parts(const std::vector<ChainLink>& chain) {
    double largest = 0;
    for (const ChainLink& link : chain) largest = std::max(largest, std::abs(link.update.key->key));
    const auto is_small = [&](std::size_t i) {
        const double key = std::abs(chain[i].update.key->key);
        return i + 1 < chain.size() && (key == 0 || key < largest / 100);
    };
    std::vector<ChainPart> parts;
    for (std::size_t end = chain.size(); end > 0; end = parts.back().first) {
        std::size_t first = end - 1;
        while (is_small(end - 1) && first > 0 && is_small(first - 1)) --first;
        parts.push_back({first, end - first});
    }
    return parts;
}

std::string folded_words(const std::vector<ChainLink>& chain, const ChainPart& part) {
    const ChainLink &first = chain[part.first], &last = chain[part.first + part.count - 1];
    double most = 0;
    for (std::size_t i = 0; i < part.count; ++i) most = std::max(most, std::abs(chain[part.first + i].update.key->key));
    return "steps " + std::to_string(first.step) + " to " + std::to_string(last.step) + ": " +
           std::to_string(part.count) + " updates from " + item_name(first.update.from) + " to " +
           item_name(last.update.item) + ", " + (most > 0 ? "keys of at most " + short_number(most) : "all keys 0");
}

std::vector<std::string> rows(const CellExplanation& cell) {
    std::vector<std::string> text;
    std::string head = "Cell " + std::to_string(cell.cell) + ": " +
                       std::string(cell_state_words[static_cast<std::size_t>(cell.mark.state)]);
    if (cell.projected_at > 0) head += " in step " + std::to_string(cell.projected_at);
    if (cell.mark.state == CellState::projected || cell.mark.state == CellState::enqueued)
        head += ", key " + short_number(cell.mark.key, cell.digits);
    if (cell.rank > 0) head += ", number " + std::to_string(cell.rank) + " in the front";
    head += "; " + share_words(cell.visible_share, 0);
    text.push_back(head + ".");
    if (cell.verdict) text.push_back("  " + std::string(verdict_title(cell)) + ": " + cell.verdict.sentence + ".");
    const auto add = [&](const ChainLink& link, const char* indent, const std::string& what) {
        text.push_back(indent + ("step " + std::to_string(link.step)) + ": " + item_name(link.update.from) + " -> " +
                       item_name(link.update.item) + ", " + what + link.update.key->formula());
    };
    for (const ChainPart& part : chain_parts(cell.chain))
        if (part.count == 1)
            add(cell.chain[part.first], "  ", "");
        else
            text.push_back("  " + folded_words(cell.chain, part));
    if (cell.reached.size() > 1) {  // the chain ends with one of them
        text.push_back("  reached through " + std::to_string(cell.reached.size()) + " facets:");
        for (const ChainLink& link : cell.reached) add(link, "    ", std::string(link.update.words) + ", ");
    }
    return text;
}

template <int D>
std::optional<std::uint32_t> shown_in_substep(const Session<D>& session, std::uint32_t step, std::uint32_t substep) {
    const Step& record = session.timeline().steps[step - 1];
    const auto changes = session.timeline().changes_of(step);
    const auto count = static_cast<std::uint32_t>(session.traversal().considered(record, changes, 3).size());
    const std::uint32_t first = session.traversal().substeps(record, changes) - count;
    return substep < first ? std::nullopt : std::optional(substep - first);
}

template std::vector<std::uint32_t> steps_of_projection<2>(const Session<2>&);
template std::vector<std::uint32_t> steps_of_projection<3>(const Session<3>&);
template std::uint32_t rank_in_front<2>(const Session<2>&, std::uint32_t);
template std::uint32_t rank_in_front<3>(const Session<3>&, std::uint32_t);
template StepExplanation explain_step<2>(const Session<2>&, std::uint32_t);
template StepExplanation explain_step<3>(const Session<3>&, std::uint32_t);
template std::vector<ChainLink> update_chain<2>(const Session<2>&, std::uint32_t);
template std::vector<ChainLink> update_chain<3>(const Session<3>&, std::uint32_t);
template std::optional<ChainLink> key_source<2>(const Session<2>&, std::uint32_t, int);
template std::optional<ChainLink> key_source<3>(const Session<3>&, std::uint32_t, int);
template CellExplanation explain_cell<2>(const Session<2>&, std::uint32_t);
template CellExplanation explain_cell<3>(const Session<3>&, std::uint32_t);
template std::optional<std::uint32_t> shown_in_substep<2>(const Session<2>&, std::uint32_t, std::uint32_t);
template std::optional<std::uint32_t> shown_in_substep<3>(const Session<3>&, std::uint32_t, std::uint32_t);

}  // namespace sightline
