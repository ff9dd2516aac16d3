// View culling, then coarser levels of detail from far to near (Dynamic Algorithm Selection, 3.1.3, first pass).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/levels/levels_parameters.h"
#include "core/run/drawing_cost.h"
#include "core/run/marks.h"
#include "core/run/method.h"
#include "core/space/levels.h"

namespace sightline {

/// What a step makes of an object.
enum class LevelRule : std::uint8_t { outside, coarser, as_it_is, enough };

/// The objects whose boxes are in the view wait, the farthest first; a step takes one and draws it, at the coarsest
/// level whose error is no larger than pixel_error pixels of the image, or as it is where there is none. Once the frame
/// is predicted to take no longer than frame_ms, the rest stays as it is.
template <int D>
class LevelsRun final : public Run<D> {
public:
    explicit LevelsRun(const Problem<D>& problem);

    bool restart(const Problem<D>&) override;
    Stop run(std::uint32_t steps, Recorder*) override;
    bool finished() const override;
    bool undoes_by_marks() const override { return true; }
    bool move(Direction, const Step&, std::span<Change>, const Counters& before) override;
    std::uint32_t substeps(const Step&, std::span<const Change>) const override { return 2; }
    void rewind_to(Step&, std::vector<Change>&, const Counters& before, std::uint32_t substep) override;
    std::unique_ptr<Run<D>> clone() const override { return std::make_unique<LevelsRun>(*this); }
    std::size_t memory_bytes() const override;
    std::uint64_t hash() const override;
    using Run<D>::mark;
    Mark mark(const Item& item) const override;
    std::vector<std::pair<Item, Mark>> front() const override { return waiting_items(marks_, Kind::object); }
    Misses misses() const override;
    std::span<const StandIn> stand_ins() const override;
    std::shared_ptr<const Levels<D>> levels() const override { return levels_; }

    /// Nothing but the object itself, of which the sentence of the step tells all.
    std::vector<Considered> considered(const Step&, std::span<const Change>, int) const override { return {}; }
    std::string popped_words(const Step& step) const override;
    Verdict why_not(const Item& item) const override;
    Verdict why_drawn(const Item& item) const override;
    std::vector<CodeLine> code(const CodePlace&) const override;
    std::span<const Field<D>> fields() const override;

    /// How many pixels the level may be off in this view.
    double error_pixels(std::uint32_t object, std::uint32_t level) const;
    /// Predicted milliseconds of the frame when so many objects have been taken, the others as they are.
    double frame_ms(std::uint32_t taken, CostReading reading) const;

private:
    void begin_objects();
    Stop next(Recorder*);
    void take(std::uint32_t object, std::uint8_t level);
    bool draw(std::uint32_t object);
    bool draw_as_it_is(std::uint32_t object);
    std::uint8_t choose(std::uint32_t object) const;
    DrawnSize size_of(std::uint32_t object, std::uint32_t level) const;
    /// What the frame costs with the first `taken` objects at their levels; in the order in which a run works it out.
    FrameDrawing frame_with(std::uint32_t taken) const;
    bool is_cheap_enough() const { return target_ms_ > 0 && frames_.back().ms(reading_) <= target_ms_; }
    bool waits_for_place() const;
    std::uint32_t place_of(std::uint32_t object) const;
    std::string object_name(std::uint32_t object) const;

    std::shared_ptr<const Levels<D>> levels_;
    PixelScale<D> scale_;
    DrawingCost cost_;
    CostReading reading_ = CostReading::sum_of_max;
    double pixel_error_ = 1, target_ms_ = 0;
    Marks marks_;                             ///< of the objects
    std::vector<std::uint32_t> order_;        ///< those in view, the farthest first; step s takes order_[s - 1]
    std::vector<std::uint8_t> level_of_;      ///< per place in the order, for those taken
    std::vector<FrameDrawing> frames_;        ///< with a target: after each step, the first before all
    std::vector<std::uint8_t> whole_groups_;  ///< 1 for groups of objects that lie in the view as a whole
    std::vector<SideSeen> facing_;            ///< 3D: per place of rows.ids, of the groups of objects in view
    std::vector<std::uint32_t> found_;        ///< scratch
    mutable std::vector<StandIn> stand_ins_;  ///< made when asked for
    mutable std::uint32_t stand_ins_at_ = 0;  ///< the number of steps that they were made after, `none`: anew
};

extern template class LevelsRun<2>;
extern template class LevelsRun<3>;

}  // namespace sightline
