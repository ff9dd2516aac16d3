// The banner of the projector mode: what a class at the back has to read.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/session/headline.h"
#include "core/session/substep.h"
#include "shell/desk/compare.h"
#include "shell/desk/into.h"
#include "shell/window/parts.h"
#include "shell/window/theme.h"

namespace sightline {

namespace {

/// A formula after some words.
Row formula_row(std::string words, const Considered& update) {
    Row row;
    row.tone = Tone::faint;
    row.text = words + update.key->formula();
    row.parts = {{std::move(words)}};
    row.parts.insert(row.parts.end(), update.key->parts.begin(), update.key->parts.end());
    if (update.key->penalised) row.parts.back().text += ", " + update.key->penalty;
    row.captions = true;
    return row;
}

/// How the key came about: of the facet that step into stands at, else of the cell just projected.
template <int D>
std::optional<Row> key_row(const Workbench<D>& bench, const StepExplanation& step) {
    const Session<D>& session = bench.session;
    const auto shown = bench.substep ? shown_in_substep(session, step.step, *bench.substep) : std::nullopt;
    if (shown) {
        const Considered& c = step.looked_at[*shown];
        if (!c.item) return Row{"across this facet: the border", Tone::faint};
        if (!c.key) return Row{item_name(c.item) + ": " + std::string(c.words), Tone::faint};
        return formula_row(item_name(c.item) + ": ", c);
    }
    if (step.cell == none) return std::nullopt;
    const std::optional<ChainLink> source = key_source(session, step.cell, step.digits);
    if (!source || !source->update.key) return Row{"its key is that of a seed", Tone::faint};
    return formula_row(
        "its key, from " + item_name(source->update.from) + " in step " + std::to_string(source->step) + ": ",
        source->update);
}

/// One run, or both with their names.
template <int D>
std::vector<Row> results(const Workbench<D>& bench, const Session<D>& shown) {
    if (!bench.other) return {{result_line(shown)}};
    const auto titles = side_titles(bench);
    return {{titles[0] + ": " + result_line(shown)}, {titles[1] + ": " + result_line(bench.other->session)}};
}

}  // namespace

template <int D>
std::vector<Row> banner_lines(const Workbench<D>& bench) {
    const ShownSession<D> shown(bench);
    const Session<D>& s = *shown;
    if (s.flying())
        return {{result_line(s)},
                {std::string(s.method().title) + " runs in each frame within its budget. F freezes one.", Tone::faint}};
    if (s.position() == 0)
        return {{headline(s)}, {"step 0 of " + std::to_string(bench.session.recorded()), Tone::faint}};
    std::vector<Row> lines = results(bench, s);
    const StepExplanation step = explain_step(s, s.position());
    lines.push_back({step_line(step, tells_truth(s), bench.other ? "Left" : "")});
    if (auto row = key_row(bench, step)) lines.push_back(std::move(*row));
    return conceal_rows(bench, std::move(lines));
}

template std::vector<Row> banner_lines<2>(const Workbench<2>&);
template std::vector<Row> banner_lines<3>(const Workbench<3>&);

}  // namespace sightline
