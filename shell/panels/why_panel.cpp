// Why this cell now; where the selected cell stands, through which facets it was reached, and what holds it back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/session/explain.h"
#include "core/session/explain_box.h"
#include "core/session/explain_primitive.h"
#include "core/session/headline.h"
#include "shell/desk/into.h"
#include "shell/desk/what_if.h"
#include "shell/panels/panel_table.h"

namespace sightline {

namespace {

class Writer {
public:
    std::vector<Row> rows;
    bool truth = true;  ///< what is visible is told

    Row& add(std::string text, int indent = 0, Tone tone = Tone::plain) {
        Row row{std::move(text), tone};
        row.indent = indent;
        return rows.emplace_back(std::move(row));
    }
    void heading(std::string text) { add(std::move(text), 0, Tone::heading); }
    /// A line about a cell: a click selects it.
    Row& cell(std::string text, std::uint32_t cell, int indent = 0, Tone tone = Tone::plain) {
        Row& row = add(std::move(text), indent, tone);
        row.cell = cell;
        row.command = "select " + std::to_string(cell);
        return row;
    }
};

std::string name(std::uint32_t cell) { return "cell " + std::to_string(cell); }

/// The formula on as many lines as it has parts. `captions`: with the names of its terms.
void write_formula(Writer& to, const Considered& update, int indent = 2, bool captions = false) {
    const KeyExplanation& key = *update.key;
    Row& sum = to.add(key.sum(), indent, Tone::faint);
    sum.tip = key.tip;
    sum.parts = key.parts;
    sum.light = light_of(update, KeyAbout::nothing);
    sum.captions = captions;
    if (!key.penalised) return;
    Row& penalty = to.add(key.penalty, indent, Tone::faint);
    penalty.parts = {{key.penalty, KeyAbout::star, "penalty"}};
    penalty.light = sum.light;
}

void write_considered(Writer& to, const Considered& c, int digits) {
    if (!c.item) {
        to.add("border: no neighbour", 1, Tone::faint);
        return;
    }
    std::string text = item_name(c.item) + ": " + std::string(c.words);
    if (c.key && c.before.state == CellState::enqueued) {
        const bool stays = c.effect == Effect::kept;
        const double now = stays ? c.before.key : c.key->key;
        const int apart = std::max(digits, separating_digits(c.before.key, now));
        text += ", key " + short_number(c.before.key, apart) + (stays ? " stays" : " → " + short_number(now, apart));
    }
    const Tone tone = c.key ? Tone::plain : Tone::faint;
    if (c.item.kind == Kind::cell)
        to.cell(text, c.item.id, 1, tone);
    else
        to.add(text, 1, tone);
    if (c.key) write_formula(to, c);
}

/// The cell that a step took, against the next one, and where its key came from.
void write_choice(Writer& to, const StepExplanation& step, const std::optional<ChainLink>& source) {
    to.cell("it had the lowest key of the front, " + short_number(step.key, step.digits), step.cell);
    const std::string next = "next was " + name(step.runner_up) + " with ";
    if (step.runner_up == none)
        to.add("it was the only cell in the front");
    else if (step.runner_up_key == step.key)
        to.cell(next + "the same key: it came into the front later", step.runner_up);
    else
        to.cell(next + short_number(step.runner_up_key, step.digits), step.runner_up);
    if (!source || !source->update.key) {
        to.add("its key is that of a seed", 0, Tone::faint);
        return;
    }
    Row& from = to.cell("its key, from " + item_name(source->update.from) + " in step " + std::to_string(source->step),
                        source->update.from.id);
    from.command = "seek " + std::to_string(source->step);
    write_formula(to, source->update, 1, true);
}

void write_step(Writer& to, const StepExplanation& step, const std::optional<ChainLink>& source, bool partly) {
    std::string title = "Step " + std::to_string(step.step);
    if (step.cell != none) title += " took " + name(step.cell);
    to.heading(title + (partly ? " (so far)" : ""));
    if (step.cell == none)
        to.add(step.words);
    else
        write_choice(to, step, source);
    std::string rendered = counted(step.rendered, "primitive") + " drawn";
    const bool judged = step.rendered > 0 && to.truth;
    if (judged) rendered += ", " + (step.visible > 0 ? std::to_string(step.visible) : "none") + " visible";
    to.add(rendered, 0, judged && step.visible > 0 ? Tone::good : Tone::plain);
    if (step.cell != none && to.truth)
        to.add(share_words(step.visible_share, step.visible), 0, step.visible_share > 0 ? Tone::good : Tone::plain);
    to.add("the code of this step", 0, Tone::link).command = "show code";
    if (step.cell != none) to.add("all inversions of this run", 0, Tone::link).command = "show inversions";
    if (!step.looked_at.empty()) to.heading(step.cell != none ? "Across its facets" : "What it looked at");
    for (const Considered& c : step.looked_at) write_considered(to, c, step.digits);
}

/// One update: a click goes to the step that made it.
void write_link(Writer& to, const ChainLink& link) {
    Row& row = to.cell("step " + std::to_string(link.step) + ": from " + item_name(link.update.from) + " to " +
                           item_name(link.update.item) + ", " + std::string(link.update.words),
                       link.update.from.id, 1);
    row.command = "seek " + std::to_string(link.step);
    if (link.update.key) write_formula(to, link.update);
}

void write_cell(Writer& to, const CellExplanation& cell, std::string_view key_name) {
    const auto state = cell_state_words[static_cast<std::size_t>(cell.mark.state)];
    to.heading("Selected: " + name(cell.cell) + ", " + std::string(state));
    if (cell.projected_at > 0) {
        Row& row = to.add("projected in step " + std::to_string(cell.projected_at));
        row.command = "seek " + std::to_string(cell.projected_at);
    }
    if (cell.mark.state == CellState::projected || cell.mark.state == CellState::enqueued)
        to.add(std::string(key_name) + " (key) " + short_number(cell.mark.key, cell.digits) +
               (cell.rank > 0 ? ", number " + std::to_string(cell.rank) + " in the front" : ""));
    if (to.truth) to.add(share_words(cell.visible_share, 0), 0, cell.visible_share > 0 ? Tone::good : Tone::faint);
    if (cell.verdict) {
        const std::string text = std::string(verdict_title(cell)) + ": " + cell.verdict.sentence;
        if (const std::uint32_t about = id_of(cell.verdict.about, Kind::cell); about != none)
            to.cell(text, about, 0, Tone::lit);
        else
            to.add(text, 0, Tone::lit);
    }
    if (!cell.reached.empty()) to.heading("Reached through " + counted(cell.reached.size(), "facet"));
    for (const ChainLink& link : cell.reached) write_link(to, link);
    if (cell.chain.size() > 1) {
        to.heading("The chain of updates, back to the seed");
        for (const ChainPart& part : chain_parts(cell.chain))
            if (part.count == 1)
                write_link(to, cell.chain[part.first]);
            else
                to.add(folded_words(cell.chain, part), 1, Tone::faint);
    }
}

template <int D>
void write_primitive(Writer& to, const Session<D>& s, const PrimitiveExplanation& e) {
    to.heading(std::string("Selected ") + (D == 2 ? "segment" : "triangle"));
    if (to.truth) to.add(sight_sentence(s, e));
    const bool missed = to.truth && e.visible && e.met_at == 0;
    Row& met = to.add(met_sentence(e, s.position()), 0, missed ? Tone::bad : Tone::plain);
    if (e.met_at > 0) met.command = "seek " + std::to_string(e.met_at);
    if (const std::uint32_t box = box_around(s, e.primitive); box != none) {
        to.add("in " + box_sentence(s, box), 1);
        return;
    }
    for (std::size_t i = 0; i < std::min(e.cells.size(), most_cells_told); ++i)
        to.cell("in " + name(e.cells[i]) + ": " + place_words(s, e.cells[i]), e.cells[i], 1);
    if (e.cells.size() > most_cells_told)
        to.add(counted(e.cells.size() - most_cells_told, "more cell"), 1, Tone::faint);
}

/// What one change would do to what is selected; a click compares the run with it.
template <int D>
void write_what_if(Writer& to, const Workbench<D>& bench) {
    const Item item = selected_item(bench);
    if (!item || (item.kind == Kind::cell && !bench.session.method().orders_cells())) return;
    to.heading("With one setting changed");
    const Counterfactuals* all = what_if(bench);
    if (!all) {
        to.add("run every change (may take seconds)", 0, Tone::link).command = "what-if";
        return;
    }
    to.add("now: " + outcome_words(all->now));
    std::uint32_t same = 0;
    std::string same_list;
    for (const auto& [change, outcome] : all->changes) {
        if (differs(outcome, all->now)) {
            to.add(change + ": " + outcome_words(outcome), 1).command = "compare " + change;
        } else {
            ++same;
            same_list += (same_list.empty() ? "" : ", ") + change;
        }
    }
    if (same > 0)
        to.add("no difference: " + counted(same, same < all->changes.size() ? "other change" : "change"), 1,
               Tone::faint)
            .tip = same_list;
}

}  // namespace

template <int D>
std::vector<Row> why_rows(const Workbench<D>& bench) {
    const Shown<D> shown(bench);
    const Session<D>& s = *shown;
    Writer to;
    to.truth = tells_truth(s);
    if (s.flying()) {
        to.heading("Flying");
        to.add("frames of a flight are not recorded: press F to freeze this one and step through it");
        return to.rows;
    } else if (s.position() == 0) {
        to.heading("Step 0");
        if (seed_cell(s) != none) to.cell("the seed " + name(seed_cell(s)) + " is in the front", seed_cell(s));
        to.add("nothing is projected yet: press Right or Space");
    } else {
        const StepExplanation step = explain_step(s, s.position());
        const auto source = step.cell == none ? std::nullopt : key_source(s, step.cell, step.digits);
        write_step(to, step, source, bench.substep.has_value());
    }
    if (s.selected_primitive != none) write_primitive(to, s, explain_primitive(bench.session, s.selected_primitive));
    if (s.selected_cell != none) write_cell(to, explain_cell(s, s.selected_cell), key_title(s));
    write_what_if(to, bench);
    if (s.selected_cell == none && s.selected_primitive == none)
        to.add("Why not another? Click a cell or a primitive to see why it is rendered, waiting or hidden.", 0,
               Tone::faint);
    return to.rows;
}

template std::vector<Row> why_rows<2>(const Workbench<2>&);
template std::vector<Row> why_rows<3>(const Workbench<3>&);

}  // namespace sightline
