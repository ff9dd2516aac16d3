// Why: a step, a cell's key and a cell's waiting, as data, as rows and as sentences.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"

namespace sightline {

/// What a step did across one facet of the cell it projected.
struct FacetExplanation {
    std::uint32_t from = none;       ///< the cell just projected
    std::uint32_t neighbour = none;  ///< none at the border
    std::uint32_t facet = 0;
    Rule rule = Rule::border;
    CellMark before;             ///< the neighbour's before the step
    std::optional<Terms> terms;  ///< where a key was computed
};

struct StepExplanation {
    std::uint32_t step = 0;
    std::uint32_t cell = none;
    double key = 0;
    std::uint32_t stamp = 0;
    std::uint32_t runner_up = none;
    double runner_up_key = 0;
    std::uint32_t rendered = 0, visible = 0;  ///< in this step; visible: of those the ones in V
    double visible_share = 0;                 ///< of the cell
    std::vector<FacetExplanation> facets;

    /// Significant digits that show its numbers and tell the popped key from the runner-up's.
    int digits() const;
};

/// `step` in [1, position()].
template <int D>
StepExplanation explain_step(const Session<D>& session, std::uint32_t step);

/// The whole formula with its numbers, one row per facet.
std::vector<std::string> rows(const StepExplanation& step, const Settings& settings);

/// One sentence: which cell, why it and not the runner-up, what it rendered.
std::string sentence(const StepExplanation& step);

/// One update on the way from the seed to a cell.
struct ChainLink {
    std::uint32_t step = 0;
    FacetExplanation update;
};

/// The updates in force, from the seed to the cell; empty for a seed and for cells not yet reached. Cost: steps +
/// cells.
template <int D>
std::vector<ChainLink> update_chain(const Session<D>& session, std::uint32_t cell);

/// Where a cell stands at the session's position, and why.
struct CellExplanation {
    std::uint32_t cell = none;
    CellMark mark;
    std::uint32_t projected_at = 0;  ///< step; 0: not yet
    std::uint32_t rank = 0;          ///< place in the front, from 1; 0: not in it
    double visible_share = 0;
    std::vector<ChainLink> chain;  ///< update_chain()
    /// Every key computed for the cell so far, in the order of steps: one for each facet that it was reached through,
    /// also where it kept the key that it had.
    std::vector<ChainLink> reached;
    std::string held_back_by;  ///< for a cell not yet projected: the term, or what keeps it from the front
    int digits = 3;            ///< StepExplanation::digits() of the last step
};

/// Cost: steps + cells, and the reference where it is not made yet.
template <int D>
CellExplanation explain_cell(const Session<D>& session, std::uint32_t cell);

std::vector<std::string> rows(const CellExplanation& cell, const Settings& settings);

/// The front, first to last.
template <int D>
std::vector<Front::Entry> front_entries(const Session<D>& session);

/// A line such as "ρ = 3/21 + 0.87 · 0.25 = 0.36, × 2 (not star-shaped) = 0.72".
std::string formula(const Terms& terms, const Settings& settings, int digits = 3);

/// Its first part, up to the penalty: "0.143 + 0.87 · 0.25 = 0.36".
std::string formula_sum(const Terms& terms, int digits = 3);

/// Its second part, of a penalised key: "× 2 (not star-shaped) = 0.72".
std::string formula_penalty(const Terms& terms, const Settings& settings, int digits = 3);

/// As few significant digits, but no fewer than 3, as tell two different keys apart.
int separating_digits(double a, double b);

}  // namespace sightline
