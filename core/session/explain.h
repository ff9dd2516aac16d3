// Why: a step, a cell's key and a cell's waiting, as data, as rows and as sentences.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/counterfactual.h"

namespace sightline {

struct StepExplanation {
    std::uint32_t step = 0;
    Item item;
    std::string words;          ///< what was popped, where it is no cell: "node 12"
    std::uint32_t cell = none;  ///< the item, where it is one
    double key = 0;
    std::string formula;  ///< of the key, where it comes from the item alone
    std::uint32_t stamp = 0;
    std::uint32_t runner_up = none;
    double runner_up_key = 0;
    std::uint32_t rendered = 0, visible = 0;  ///< in this step; visible: of those the ones in V
    std::uint32_t stood_in = 0;               ///< primitives of a level, drawn in place of an object's
    double visible_share = 0;                 ///< of the cell
    std::vector<Considered> looked_at;        ///< in order; of a cell: a row per facet
    int digits = 3;                           ///< significant digits that tell the popped key from the runner-up's
};

/// `step` in [1, position()].
template <int D>
StepExplanation explain_step(const Session<D>& session, std::uint32_t step);

/// The whole formula with its numbers, one row per thing that the step looked at.
std::vector<std::string> rows(const StepExplanation& step);

/// One sentence: which cell, why it and not the runner-up, what it rendered.
std::string sentence(const StepExplanation& step);

/// One update on the way from the seed to a cell.
struct ChainLink {
    std::uint32_t step = 0;
    Considered update;
};

/// The updates in force, from the seed to the cell; empty for a seed and for cells not yet reached. Cost: steps +
/// cells.
template <int D>
std::vector<ChainLink> update_chain(const Session<D>& session, std::uint32_t cell);

/// The update that gave a cell the key that it has, or had when it was projected; nothing for a seed and for cells not
/// yet reached. `digits` as StepExplanation's. Cost: steps.
template <int D>
std::optional<ChainLink> key_source(const Session<D>& session, std::uint32_t cell, int digits);

/// A key lower than the one that a cell in the front has, which a rule threw away or did not take.
struct LostKey {
    double key = 0;
    std::uint32_t step = 0;           ///< that computed it
    double instead = 0;               ///< what the cell had or got in its place
    std::uint32_t lost_in = 0;        ///< the step that threw it away: `step` itself where it was not taken
    bool taken = false;               ///< it was the cell's key for a while
    std::optional<Outcome> with_min;  ///< of the cell with on_reenqueue=min, where the method has that parameter
};

/// Per cell the step, up to the position, that projected it, alone or in a round; 0: none.
template <int D>
std::vector<std::uint32_t> steps_of_projection(const Session<D>& session);

/// A cell's place in the front, from 1; 0: it is not in it.
template <int D>
std::uint32_t rank_in_front(const Session<D>& session, std::uint32_t cell);

/// Where a cell stands at the session's position, and why.
struct CellExplanation {
    std::uint32_t cell = none;
    Mark mark;
    std::uint32_t projected_at = 0;  ///< step; 0: not yet
    std::uint32_t rank = 0;          ///< place in the front, from 1; 0: not in it
    double visible_share = 0;
    std::vector<ChainLink> chain;  ///< update_chain()
    /// Every key computed for the cell so far, in the order of steps: one for each facet that it was reached through,
    /// also where it kept the key that it had.
    std::vector<ChainLink> reached;
    /// For a cell not yet projected: what holds it back, or why it is not there.
    Verdict verdict;
    std::optional<LostKey> lost;  ///< the lowest one, where one was lower than the cell's key
    int digits = 3;               ///< StepExplanation::digits of the last step
};

/// Cost: steps + cells, a run of the method where a key was lost, and the reference where it is not made yet.
template <int D>
CellExplanation explain_cell(const Session<D>& session, std::uint32_t cell);

std::vector<std::string> rows(const CellExplanation& cell);

/// What the visible share says of a step beside the primitives that it rendered.
std::string share_words(double visible_share, std::uint32_t visible);

/// "held back by" or "not in the front", before the verdict.
std::string_view verdict_title(const CellExplanation& cell);

/// A part of a chain: one update, or several whose keys are about nothing beside the largest key of the chain, below a
/// hundredth of it: those are told in one line.
struct ChainPart {
    std::size_t first = 0, count = 1;  ///< in the chain
};
/// From the chain's end, which decides and is never folded, back to the seed.
std::vector<ChainPart> chain_parts(const std::vector<ChainLink>& chain);
std::string folded_words(const std::vector<ChainLink>& chain, const ChainPart& part);

/// Which of the things that a step looked at a substep shows: an index into StepExplanation::looked_at. Nothing where
/// it shows the pop or the rendering.
template <int D>
std::optional<std::uint32_t> shown_in_substep(const Session<D>& session, std::uint32_t step, std::uint32_t substep);

/// The end of a row about a waiting item that was reached again: "key before 0.549, now 0.938"; "… stays". Empty for
/// any other.
std::string key_before(const Considered& considered, int digits);

}  // namespace sightline
