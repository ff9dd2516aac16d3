// The trade-off of speed and accuracy of one scene and its cells, measured in slices, for callers that must stay
// responsive.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/measure/frame_clock.h"
#include "core/measure/frame_numbers.h"
#include "core/run/budget.h"
#include "core/space/cell_complex.h"

namespace sightline {

/// What is measured.
template <int D>
struct TradeOffTask {
    std::shared_ptr<const Scene<D>> scene{};
    std::shared_ptr<const CellComplex<D>> cells{};
    ImageSize reference_size{};
    std::vector<View<D>> views{};
    std::vector<View<D>> before{};  ///< of each view the frame before it; empty: methods that look at it have none
    std::vector<Variant<D>> variants{};
    std::optional<Budget> budget{};  ///< in place of the usual ones; not one in milliseconds
    DrawIds draw_ids{};              ///< 3D; empty: in software
    TimeDrawing time_drawing{};      ///< 3D; empty: drawing is not timed
};

/// A variant at a budget; what it makes of the views so far, in their order.
struct TradeOffDot {
    std::size_t variant = 0;  ///< index into TradeOffTask::variants
    Budget budget;
    std::vector<Values> frames{};
    bool asked = false;  ///< one of the usual budgets is not
};

/// Methods at 1, 2, 5 and 10 % of the scene, those that have no use for a budget without one; view by view.
template <int D>
class TradeOffStudy {
public:
    TradeOffStudy() = default;  ///< nothing to measure
    explicit TradeOffStudy(TradeOffTask<D> task);

    /// Measures this variant too, and it at this budget, where that is none of the usual ones; the budget that was
    /// asked for before is dropped. One in milliseconds, and one of a method that has no use for it, is not measured.
    void ask(const Variant<D>& variant, const Budget& budget);

    /// One slice: the exact image of a view, a piece of a run, the numbers of one budget, or one timed traversal or
    /// drawing. False when there is nothing left to do. Throws WorkError where drawing is timed and there is no OpenGL.
    bool advance();

    const TradeOffTask<D>& task() const { return task_; }
    const std::vector<TradeOffDot>& dots() const { return dots_; }
    bool finished() const { return done() == total(); }
    /// The dot that the next slice is for, whose next view it is for; nullptr: all are finished.
    const TradeOffDot* next_dot() const;
    /// Views x variants x budgets measured, and there are.
    std::size_t done() const;
    std::size_t total() const { return dots_.size() * task_.views.size(); }
    /// Views that all usual dots have measured.
    std::size_t common_views() const;
    /// The mean (times: the median) over the views that all have, or over the first one until they do, so that dots
    /// compare. NaN before.
    double value(const TradeOffDot& dot, Measure measure) const;

private:
    struct Work {
        std::size_t view = 0, variant = 0;
        std::uint32_t run_budget = none;  ///< of its run; none: one that serves all budgets
        Problem<D> problem{};
        std::optional<WholeRunner<D>> runner{};
        std::optional<WholeRun> run{};
        // Of the dot that is being measured.
        std::optional<Budget> budget{};
        Values values{};
        std::uint32_t samples = 0;                ///< taken, those to warm up included
        std::shared_ptr<const Scene<D>> drawn{};  ///< what is timed is drawn of
        TimeSamples times{};
    };
    void add_usual_dots(std::size_t variant);
    void make_truth(std::size_t view);
    void measure(const TradeOffDot& dot);
    void take_time(TradeOffDot& dot);
    std::uint32_t primitives(const Budget& budget) const;

    TradeOffTask<D> task_;
    std::vector<TradeOffDot> dots_;
    std::optional<std::size_t> truth_view_;
    Truth truth_;
    std::optional<Work> work_;
    std::vector<OwnRun<D>> timed_;  ///< of the variants
    std::vector<std::uint32_t> ids_;
};

}  // namespace sightline
