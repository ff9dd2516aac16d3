// Why this cell now; where the selected cell stands, through which facets it was reached, and what holds it back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/draw/shown_planes.h"
#include "core/session/explain.h"
#include "core/session/explain_box.h"
#include "core/session/explain_primitive.h"
#include "core/session/headline.h"
#include "core/session/pixel_history.h"
#include "core/space/box_tree.h"
#include "shell/desk/faults.h"
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
    if (step.cell == none) {
        to.add(step.words);
        if (!step.formula.empty()) to.add(step.formula, 1, Tone::faint);
    } else {
        write_choice(to, step, source);
    }
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

/// What lies behind a pixel, nearest first, and when each was rendered.
void write_pixel(Writer& to, const Session<3>& s, const std::array<int, 2>& pixel) {
    constexpr std::size_t most_layers_told = 8;
    const PixelHistory history = pixel_history(s, pixel[0], pixel[1]);
    to.heading("Pixel " + std::to_string(history.x) + "," + std::to_string(history.y) + " of the exact image");
    const auto named = [&](std::uint32_t primitive) { return primitive_name(s.scene(), primitive); };
    const auto line = [&](const std::string& text, std::uint32_t primitive, int indent, Tone tone) {
        Row& row = to.add(text, indent, tone);
        row.command = "select primitive:" + std::to_string(primitive);
    };
    if (history.should_own == none)
        to.add("nothing is there: the background is right");
    else if (history.should_own == history.owns)
        line("right: " + named(history.owns) + " is there", history.owns, 0, Tone::good);
    else
        line("should show " + named(history.should_own) + ", shows " +
                 (history.owns == none ? "nothing" : named(history.owns)),
             history.should_own, 0, Tone::bad);
    if (history.tie) to.add("both lie equally near: a tie, which each image decides in its own way", 0, Tone::faint);
    for (std::size_t i = 0; i < std::min(history.layers.size(), most_layers_told); ++i) {
        const PixelLayer& layer = history.layers[i];
        std::string when = "no step renders it";
        if (layer.met_at > 0)
            when = (layer.met_at <= s.position() ? "rendered in step " : "will be rendered in step ") +
                   std::to_string(layer.met_at);
        line(
            std::to_string(i + 1) + ": " + named(layer.primitive) + " at " + short_number(layer.distance) + ", " + when,
            layer.primitive, 1, layer.met_at > 0 ? Tone::plain : Tone::faint);
    }
    if (history.layers.size() > most_layers_told)
        to.add(std::to_string(history.layers.size() - most_layers_told) + " more behind them", 1, Tone::faint);
}
void write_pixel(Writer&, const Session<2>&, const std::array<int, 2>&) {}

/// Of the object that the primitive belongs to.
template <int D>
void write_object(Writer& to, const Workbench<D>& bench, std::uint32_t primitive) {
    const Faults* const known = faults(bench);
    if (!known || !known->objects) return;
    const std::uint32_t object = bench.session.objects().of[primitive];
    for (const ObjectReport& report : *known->objects)
        if (report.object == object)
            to.add(bench.session.objects().names[object] + ": " + verdict_words<D>(report), 0, Tone::faint).command =
                "show objects";
}

/// What decides comes first: whether it is seen, whether it is rendered, and which cell put it off why.
template <int D>
void write_primitive(Writer& to, const Session<D>& s, const PrimitiveExplanation& e) {
    to.heading("Selected " + primitive_name(s.scene(), e.primitive));
    if (to.truth) to.add(sight_sentence(s, e));
    const bool missed = to.truth && e.visible && e.met_at == 0;
    Row& met = to.add(met_sentence(e, s.position()), 0, missed ? Tone::bad : Tone::plain);
    if (e.met_at > 0) met.command = "seek " + std::to_string(e.met_at);
    if (const std::uint32_t box = box_around(s, e.primitive); box != none) {
        if (box != box_at_hand(s))
            to.add("in " + box_sentence(s, box), 1).command = "select node:" + std::to_string(box);
        if (const std::string why = put_off_sentence(s, e); !why.empty()) to.add(why, 1, Tone::lit);
        return;
    }
    if (const std::string why = put_off_sentence(s, e); !why.empty()) to.cell(why, e.cells.front(), 0, Tone::lit);
}

/// The cells that hold a primitive, the one that comes first in front.
template <int D>
void write_cells_of(Writer& to, const Session<D>& s, const PrimitiveExplanation& e) {
    if (box_around(s, e.primitive) != none || e.cells.empty()) return;
    to.heading("Cells that hold it");
    for (std::size_t i = 0; i < std::min(e.cells.size(), most_cells_told); ++i)
        to.cell("in " + name(e.cells[i]) + ": " + place_words(s, e.cells[i]), e.cells[i], 1);
    if (e.cells.size() > most_cells_told)
        to.add(counted(e.cells.size() - most_cells_told, "more cell"), 1, Tone::faint);
}

template <int D>
std::string name_of(std::span<const std::uint32_t> primitives) {
    constexpr std::size_t most_named = 3;
    return some_of(D == 2 ? "segment" : "triangle", primitives, most_named);
}

/// "supporting, edge 2: satisfied, 0.31", those that fail first; a click points one out in the picture.
template <int D>
void write_planes(Writer& to, const Session<D>& s, std::span<const TestedOccluder> tested) {
    const std::vector<TestedPlane<D>> planes = planes_at_hand(s);
    if (planes.empty()) return;
    const std::uint32_t selected = occluder_at_hand(s);
    const bool together =
        std::count_if(tested.begin(), tested.end(), [](const TestedOccluder& o) { return o.hides; }) > 1;
    to.heading(selected != none ? "Planes to the selected occluder"
               : together       ? "Planes to those that hide it together; edges they share are none"
                                : "Planes to the occluder that comes nearest to hiding it");
    for (const bool satisfied : {false, true})
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const TestedPlane<D>& plane = planes[i];
            if (plane.satisfied != satisfied) continue;
            const std::string edge = (D == 2 ? "end " : "edge ") + std::to_string(plane.edge);
            std::string text = satisfied ? "✓ " : "✗ ";
            text += plane.kind == PlaneKind::own
                        ? std::string("the occluder's own")
                        : std::string(plane_kind_words[static_cast<std::size_t>(plane.kind)]) + ", " + edge;
            text += (satisfied ? ": satisfied, " : ": not satisfied, ") + short_number(plane.distance);
            Row& row = to.add(std::move(text), 1,
                              i == s.selected_plane ? Tone::lit
                              : satisfied           ? Tone::good
                                                    : Tone::bad);
            row.command = "select plane:" + std::to_string(i);
            row.tip = plane.kind == PlaneKind::own          ? "how far the box lies beyond the occluder's own plane"
                      : plane.kind == PlaneKind::supporting ? "satisfied: past this edge the eye sees nothing of the "
                                                              "box; the number is how far the eye can move, or has to"
                                                            : "satisfied: this edge may hide a part of the box; the "
                                                              "number is how far the eye can move, or has to";
        }
}

template <int D>
void write_occluder(Writer& to, const TestedOccluder& occluder, std::uint32_t node) {
    static constexpr std::array<std::string_view, 3> words{"hides nothing of it", "may hide a part", "hides it"};
    std::string text = name_of<D>(occluder.primitives) + ": region " + std::to_string(occluder.region) + ", ";
    text += occluder.hides && occluder.region < 3 ? "hides it with others" : words[occluder.region - 1u];
    to.add(std::move(text), 1,
           occluder.hides       ? Tone::good
           : occluder.handed_on ? Tone::plain
                                : Tone::faint)
        .command =
        "select node:" + std::to_string(node) + "; select primitive:" + std::to_string(occluder.primitives.front());
}

/// The occluders S that the box was tested against, and those S' that the boxes in it are tested against.
template <int D>
void write_occluders(Writer& to, const Session<D>& s, std::uint32_t node, std::span<const TestedOccluder> tested) {
    const auto matters = [](const TestedOccluder& occluder) { return occluder.hides || occluder.handed_on; };
    const auto some = std::count_if(tested.begin(), tested.end(), matters);
    to.heading("Tested against it: S, " + counted(tested.size(), "occluder"));
    if (tested.empty()) to.add("no occluder hides a part of the box around it", 1, Tone::faint);
    for (const TestedOccluder& occluder : tested) write_occluder<D>(to, occluder, node);
    if (some == 0 || std::any_of(tested.begin(), tested.end(), [](const auto& o) { return o.hides; })) return;
    const bool leaf = s.traversal().boxes()->nodes[node].first_child == none;
    to.heading(leaf ? "Of them, those that may hide a part: S'" : "Handed on to the boxes in it: S'");
    for (const TestedOccluder& occluder : tested)
        if (occluder.handed_on) write_occluder<D>(to, occluder, node);
}

template <int D>
void write_box(Writer& to, const Session<D>& s, std::uint32_t node) {
    const bool is_selected = node == s.selected_node;
    Row& row = to.add((is_selected ? "Selected: " : "Box: ") + item_name({node, Kind::node}), 0, Tone::heading);
    if (!is_selected) row.command = "select node:" + std::to_string(node);
    std::string sentence = box_sentence(s, node);
    const std::string name = item_name({node, Kind::node}) + ", ";
    if (sentence.starts_with(name)) sentence.erase(0, name.size());
    to.add(std::move(sentence), 0, Tone::lit);
    if (!s.traversal().tests_planes()) return;
    const CellState state = s.traversal().mark(Item{node, Kind::node}).state;
    if (state == CellState::clean || state == CellState::unseen || state == CellState::enqueued) return;
    const std::vector<TestedOccluder> tested = s.traversal().tested_occluders({node, Kind::node});
    write_planes(to, s, tested);
    write_occluders(to, s, node, tested);
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
    const ShownSession<D> shown(bench);
    const Session<D>& s = *shown;
    Writer to;
    to.truth = tells_truth(s);
    if (s.flying()) {
        to.heading("Flying");
        to.add("frames of a flight are not recorded: press F to freeze this one and step through it");
        return to.rows;
    }
    const bool nothing = s.selected_cell == none && s.selected_node == none && s.selected_primitive == none;
    if (const Faults* const found = faults(bench); nothing && found && !found->missed.regions.empty())
        to.add(percent_text(found->missed.share()) + " of the pixels are wrong at the end of this run. Why is " +
                   primitive_name(s.scene(), found->missed.regions.front().primitives.front().primitive) +
                   " missed, in the largest wrong region?",
               0, Tone::link)
            .command = "missed 1";
    if (bench.pixel) write_pixel(to, s, *bench.pixel);
    if (s.selected_primitive != none) {
        const PrimitiveExplanation e = explain_primitive(bench.session, s.selected_primitive);
        write_primitive(to, s, e);
        write_what_if(to, bench);
        write_cells_of(to, s, e);
        write_object(to, bench, s.selected_primitive);
    }
    // What a person has clicked comes before the step; the cell of the step itself belongs behind it.
    const bool after = s.selected_cell != none && (s.selected_primitive != none || s.selected_cell == last_cell(s));
    if (s.selected_cell != none && !after) write_cell(to, explain_cell(s, s.selected_cell), key_title(s));
    if (s.selected_primitive == none) write_what_if(to, bench);
    if (s.position() == 0) {
        to.heading("Step 0");
        if (seed_cell(s) != none) to.cell("the seed " + name(seed_cell(s)) + " is in the front", seed_cell(s));
        to.add("nothing is projected yet: press Right or Space");
    } else {
        const StepExplanation step = explain_step(s, s.position());
        const auto source = step.cell == none ? std::nullopt : key_source(s, step.cell, step.digits);
        write_step(to, step, source, bench.substep.has_value());
    }
    if (const std::uint32_t node = box_at_hand(s);
        node != none && (s.traversal().tests_planes() || node == s.selected_node))
        write_box(to, s, node);
    if (after) write_cell(to, explain_cell(s, s.selected_cell), key_title(s));
    if (nothing)
        to.add("Why not another? Click a cell or a primitive to see why it is rendered, waiting or hidden.", 0,
               Tone::faint);
    return to.rows;
}

template std::vector<Row> why_rows<2>(const Workbench<2>&);
template std::vector<Row> why_rows<3>(const Workbench<3>&);

}  // namespace sightline
