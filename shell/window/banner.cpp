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

/// How the key came about: of the facet that step into stands at, else of the cell just projected.
template <int D>
std::string formula_line(const Workbench<D>& bench, const StepExplanation& step) {
    const Session<D>& session = bench.session;
    const auto shown = bench.substep ? shown_in_substep(session, step.step, *bench.substep) : std::nullopt;
    if (shown) {
        const Considered& c = step.looked_at[*shown];
        if (!c.item) return "across this facet: the border";
        return item_name(c.item) + ": " + (c.key ? c.key->formula() : std::string(c.words));
    }
    if (step.cell == none) return "";
    const CellExplanation cell = explain_cell(session, step.cell);
    if (cell.chain.empty() || !cell.chain.back().update.key) return "its key is that of a seed";
    const ChainLink& link = cell.chain.back();
    return "its key, from " + item_name(link.update.from) + " in step " + std::to_string(link.step) + ": " +
           link.update.key->formula();
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
    const Shown<D> shown(bench);
    const Session<D>& s = *shown;
    if (s.flying())
        return {{result_line(s)},
                {std::string(s.method().title) + " runs in each frame within its budget. F freezes one.", Tone::faint}};
    if (s.position() == 0)
        return {{headline(s)}, {"step 0 of " + std::to_string(bench.session.recorded()), Tone::faint}};
    std::vector<Row> lines = results(bench, s);
    const StepExplanation step = explain_step(s, s.position());
    const std::string of_left = bench.other ? "Left, " : "";
    std::string did = of_left + step_line(step, tells_truth(s));
    if (bench.other && did.size() > of_left.size()) did[of_left.size()] = 's';  // "Left, step 7 took"
    lines.push_back({std::move(did)});
    if (std::string formula = formula_line(bench, step); !formula.empty())
        lines.push_back({std::move(formula), Tone::faint});
    return lines;
}

template std::vector<Row> banner_lines<2>(const Workbench<2>&);
template std::vector<Row> banner_lines<3>(const Workbench<3>&);

}  // namespace sightline
