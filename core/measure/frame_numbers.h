// What one method makes of one frame at any budget. A budget selects a prefix of the order (design.md, principle 4), so
// that one run to the end has them all.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/measure/inversion.h"
#include "core/measure/measure_table.h"
#include "core/measure/metrics.h"
#include "core/run/method.h"
#include "core/truth/truth.h"

namespace sightline {

/// A cell that a step took from the front.
struct PoppedCell {
    std::uint32_t step = 0;  ///< from 1
    std::uint32_t cell = none;
    double key = 0;
};

/// A method's run over one frame without a budget.
struct WholeRun {
    std::vector<Met> met;
    std::vector<std::uint32_t> touched_after;          ///< per step, how many of them were met by its end
    std::vector<std::uint32_t> largest_front;          ///< per step, the most cells in the front after it or one before
    std::optional<std::vector<Inversion>> inversions;  ///< by step; nothing: not made
    std::optional<std::uint32_t> k95;                  ///< rendered primitives with coverage >= 0.95 for the first time
    bool culled_costs = false;                         ///< the parameter culled_cost
    std::vector<PoppedCell> popped_cells{};            ///< in the order of the steps
    std::vector<std::uint32_t> zero_keys_after;        ///< per step, how many popped a cell with key 0; empty: no cells
    bool whole = false;                         ///< no budget cuts it: it was made with its own (Method::prefixes)
    std::vector<std::uint64_t> tests_after{};   ///< per step
    std::vector<std::uint32_t> rounds_after{};  ///< per step
    std::vector<std::uint32_t> spent_after;     ///< per step, with budget_counts=per_cell; else empty
    // At its end; empty for runs without levels of detail.
    std::vector<std::uint32_t> stood_in{};     ///< primitives whose objects are drawn at a level
    std::uint32_t drawn_levels = 0;            ///< primitives of those levels
    std::vector<std::uint8_t> levels_wrong{};  ///< wrong_mask() of the run; of a run without levels `met` tells it
};

/// The same in slices, for callers that must stay responsive.
template <int D>
class WholeRunner {
public:
    /// `problem`, with its budget lifted where a budget selects a prefix; what it points to must live longer.
    WholeRunner(const Method<D>& method, Problem<D> problem);
    /// At most `steps` steps; false when the run is at its end.
    bool advance(std::uint32_t steps);
    /// When it is. `with_inversions`: they take as long as the run itself. `draw_ids` drew the reference (3D; empty: in
    /// software); it is asked only where levels of detail are drawn.
    WholeRun finish(const Reference& reference, bool with_inversions, const DrawIds& draw_ids);

private:
    OwnRun<D> run_;
    Recording recording_;
    WholeRun whole_;
    std::uint32_t largest_front_ = 0, zero_keys_ = 0, rounds_ = 0;
    bool counts_cells_ = false;
};

/// A WholeRunner from its start to its end.
template <int D>
WholeRun whole_run(const Method<D>& method, Problem<D> problem, const Reference& reference, bool with_inversions = true,
                   const DrawIds& draw_ids = {});

/// Where a budget ends a run.
struct Cut {
    std::size_t met = 0;    ///< so many of WholeRun::met, culled ones behind the last rendered left out
    std::size_t steps = 0;  ///< steps taken, the one that the budget cuts included
};
Cut cut_at(const WholeRun& run, std::uint32_t budget);

/// The smallest budget that leaves at most such a share of the pixels wrong, and is no larger than `most`; none: none
/// does. A larger budget leaves no more wrong, since a visible primitive that is rendered wins its pixels.
std::uint32_t needed_budget(const WholeRun& run, const Reference& reference, double most_wrong, std::uint32_t most);

/// Per primitive, 1 where it is among the first `met` of the run's and not culled, or its object drawn at a level.
std::vector<std::uint8_t> rendered_by(const WholeRun& run, std::size_t met, std::size_t primitive_count);

/// Per pixel of the exact image, 1 where it is wrong when that is rendered.
std::vector<std::uint8_t> wrong_by(const WholeRun& run, const IdImage& exact, std::span<const std::uint8_t> rendered);

/// Key and visible share of each cell popped within so many steps; empty for a reference without shares.
struct KeysAndShares {
    std::vector<double> keys, shares;
};
KeysAndShares keys_and_shares(const WholeRun& run, const Reference& reference, std::size_t steps);

/// Every measure of a frame on its own: no times, and nothing that compares with another frame. `rendered` is
/// rendered_by, `wrong` wrong_by at this budget; `best_cells` the cell oracle, which depends on the tessellation
/// only.
Values frame_numbers(const WholeRun& run, const Truth& truth, std::uint32_t budget,
                     std::span<const std::uint8_t> rendered, std::span<const std::uint8_t> wrong,
                     std::optional<double> best_cells);

}  // namespace sightline
