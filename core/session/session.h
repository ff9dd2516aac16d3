// A session: a scene, its cells, a view, settings and a recorded traversal that goes forward and back. A value: copy it
// to branch, keep two side by side to compare. No globals.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/measure/inversion.h"
#include "core/measure/metrics.h"
#include "core/methods/method_table.h"
#include "core/run/frame_cost.h"
#include "core/run/timeline.h"
#include "core/scene/scene_view.h"
#include "core/session/note.h"
#include "core/session/settings_table.h"

namespace sightline {

/// A named place in the timeline.
struct Bookmark {
    std::uint32_t step = 0;
    std::string label;
    bool operator==(const Bookmark&) const = default;
};

/// Where moving forward is asked to stop; the text is one that Condition takes.
struct Breakpoint {
    std::string condition;
    bool on = true;
    bool operator==(const Breakpoint&) const = default;
};

/// Something worth a mark on the timeline, found by looking at the recording.
struct Marker {
    enum class Kind : std::uint8_t { penalty, mis_ranked, unreached, budget, first_wrong, pop };
    std::uint32_t step = 0;
    Kind kind = Kind::penalty;
    std::string label;
};
inline constexpr auto marker_words =
    std::to_array<std::string_view>({"penalty", "mis-ranked", "unreached", "budget", "first wrong pixel", "pop"});

/// What of the culling view stays where it is when the display view moves.
enum class Frozen : std::uint8_t { nothing, eye, direction, all };
inline constexpr auto frozen_words = std::to_array<std::string_view>({"nothing", "eye", "direction", "all"});

/// Milliseconds spent making the parts of a session.
struct Times {
    double read = 0, tessellate = 0, assign = 0, reference = 0, traverse = 0, draw = 0;
};

template <int D>
class Session {
public:
    /// Tessellates, starts the traversal and stays at step 0. 3D: `draw_ids` draws the reference. `cells`: what
    /// build_cells() makes of the scene with these settings, where that is at hand. Throws InputError for a view or a
    /// method that cannot be.
    Session(std::shared_ptr<const Scene<D>> scene, const ViewSpec<D>& view, const Settings& settings,
            std::span<const Method<D>> methods = method_table<D>(), DrawIds draw_ids = {},
            const Progress& progress = {}, std::shared_ptr<const CellComplex<D>> cells = {});

    // What there is. A step number counts the steps taken: 0 is the start.
    const Scene<D>& scene() const { return *scene_; }
    const CellComplex<D>& cells() const { return *cells_; }
    const Settings& settings() const { return settings_; }
    const Method<D>& method() const { return method_; }
    const ViewSpec<D>& culling_view() const { return culling_view_; }
    const ViewSpec<D>& display_view() const { return frozen() ? display_view_ : culling_view_; }
    bool frozen() const { return frozen_ != Frozen::nothing; }
    Frozen frozen_part() const { return frozen_; }
    const Run<D>& traversal() const { return *run_; }
    const Problem<D>& problem() const { return run_->problem(); }
    const Counters& counters() const { return run_->counters(); }
    std::span<const Met> met() const { return run_->met(); }
    Mark mark(std::uint32_t cell) const { return run_->mark(cell); }
    const Timeline<D>& timeline() const { return timeline_; }
    std::uint32_t position() const { return flying_ ? 0 : run_->steps(); }
    std::uint32_t recorded() const { return timeline_.size(); }
    /// Whether the run ends here: step() would say why.
    bool finished() const;
    /// "approximate", "conservative", … of this run, here (method.h).
    std::string guarantee() const { return guarantee_words(method_, *run_); }
    std::uint64_t hash() const { return run_->hash(); }
    const Times& times() const { return times_; }
    Times& times() { return times_; }

    // Moving in time.
    /// One step forward. Stop::none when it was made, else why not.
    Stop step();
    /// One step back; false at the start.
    bool back();
    /// Forward until something stops it: the budget, the empty front, or `steps` steps made.
    Stop run(std::uint32_t steps = none);
    /// Forward, at least one step, until `holds(*this)` after a step (Stop::breakpoint).
    Stop run_until(const std::function<bool(const Session&)>& holds);
    /// To a step (Stop::steps), or as near as the budget and the front allow (why not nearer).
    Stop seek(std::uint32_t step);
    /// Where a budget in milliseconds ended the run; none before it ran. Sidecars give it back so that a replay ends
    /// at the same step.
    std::uint32_t time_stop() const { return time_stop_; }
    void set_time_stop(std::uint32_t step) { time_stop_ = step; }
    /// What upload and drawing will cost: a budget in milliseconds leaves so much for them. Who draws says it; nothing
    /// where nobody does.
    const FrameCost& frame_cost() const { return frame_cost_; }
    void set_frame_cost(const FrameCost& cost) { frame_cost_ = cost; }

    /// A copy, for pictures and words only, that shows the last step done up to and including one of its substeps
    /// (substep.h): nothing further is in its marks, its counters or its record of the step. The session itself from
    /// the last substep on, and at step 0.
    Session in_the_middle(std::uint32_t substep) const;

    // The lane of frames: what a method that needs a history was shown before this frame.
    /// Runs these views one after the other, as a flight does; what they leave is the history of the frame at hand.
    void set_lane(std::vector<ViewSpec<D>> lane);
    const std::vector<ViewSpec<D>>& lane() const { return lane_; }
    /// Goes back into frame i of the lane: runs it again with a recording, after those before it.
    void step_into(std::size_t frame);

    // Changing it. Each keeps the step as far as the new traversal has it, and the selection.
    /// What was made again.
    Invalidates change(const Settings& settings);
    /// Throws InputError that lists the fields of the run, for the name of one that it does not have.
    void check(const CellNumber& number) const;
    /// Throws InputError for an invalid view.
    void check(const ViewSpec<D>& view) const;
    /// Moves the culling view; while frozen the display view, which takes along what of the culling view is not frozen.
    void set_view(const ViewSpec<D>& view);
    /// Moves the culling view, also while frozen.
    void set_culling_view(const ViewSpec<D>& view);
    /// Another soup of primitives under the same views and settings, e.g. after an edit. What referred to a primitive
    /// or a cell that no longer exists is dropped.
    void set_scene(std::shared_ptr<const Scene<D>> scene);
    const std::shared_ptr<const Scene<D>>& shared_scene() const { return scene_; }
    const std::shared_ptr<const CellComplex<D>>& shared_cells() const { return cells_; }
    void freeze(Frozen part = Frozen::all);
    void unfreeze() { frozen_ = Frozen::nothing; }

    // Flying: frames that follow each other and are not recorded.
    /// Moves the culling view and runs to the budget without a recording. Until land() there is nothing to step
    /// through: recorded() and position() are 0, while state() has the whole frame.
    Stop fly(const ViewSpec<D>& view);
    bool flying() const { return flying_; }
    /// Runs the frame again with a recording: the same steps, the same hash. Does nothing when not flying. Everything
    /// that moves or changes the session lands first.
    void land();

    // What people put into it.
    std::vector<Bookmark> bookmarks;
    std::vector<Note<D>> notes;
    std::vector<Breakpoint> breakpoints;
    std::uint32_t selected_cell = none;
    std::uint32_t selected_primitive = none;
    std::uint32_t selected_node = none;   ///< of the tree that the run walks
    std::uint32_t selected_plane = none;  ///< of those between that box and its occluder (Run::tested_planes)

    /// Facets of the cell of a step, 1 <= step <= position(), across which it gave a key that carries a penalty.
    std::vector<HalfFacet> penalised_facets(std::uint32_t step) const;

    /// Those that the scene names, else the parts that hang together; made on first use.
    const Objects& objects() const;

    // Measured, made on first use.
    const Reference& reference() const;
    bool has_reference() const { return reference_ != nullptr; }
    /// Layering number ζ of each primitive; 0: hit by no ray (visible_set.h).
    const std::vector<std::uint32_t>& layering() const;
    /// Of those, what is rendered so far, or whose object is drawn at a level.
    std::size_t visible_rendered() const;
    /// Per pixel of the reference's image 1 where what is drawn so far shows something else; kept until more is drawn.
    const std::vector<std::uint8_t>& wrong_mask() const;
    /// The share of ones in it.
    double wrong_pixels() const;
    /// Of the whole recording, most wasted primitives first.
    std::vector<Inversion> inversions() const;
    /// Of one recorded step; nothing: it is none.
    std::optional<Inversion> inversion_at(std::uint32_t step) const;
    /// Penalties, inversions, the first wrong pixel (first_wrong.h) and the ticks of 1, 2, 5 and 10 % budget, by step.
    std::vector<Marker> markers() const;

private:
    void tessellate(const Progress& progress = {});
    void aim(const ViewSpec<D>& view);
    void restart();
    void start_again(std::uint32_t step);
    void resolve_method(Settings& settings, Method<D>& method) const;
    const Inversions& followed_inversions() const;
    void drop_dangling();
    void forget_measures();
    /// The one way forward: until the budget, the empty front, `steps` steps, or `holds` after a step.
    template <typename Holds>
    Stop advance(std::uint32_t steps, Holds holds);

    std::shared_ptr<const Scene<D>> scene_;
    std::shared_ptr<const CellComplex<D>> cells_;
    std::span<const Method<D>> methods_;
    Method<D> method_;
    Settings settings_;
    DrawIds draw_ids_;
    ViewSpec<D> culling_view_, display_view_;
    View<D> view_;
    Frozen frozen_ = Frozen::nothing;
    bool flying_ = false;
    OwnRun<D> run_;  ///< points into what scene_ and cells_ own, which copies of the session share
    Timeline<D> timeline_;
    std::vector<ViewSpec<D>> lane_;
    std::shared_ptr<const FrameHistory> history_;
    std::uint32_t time_stop_ = none;
    FrameCost frame_cost_;
    mutable std::shared_ptr<const Reference> reference_;
    mutable std::shared_ptr<const std::vector<std::uint32_t>> layering_;
    mutable std::shared_ptr<const Objects> objects_;
    mutable std::optional<Inversions> inversions_;
    struct Wrong {
        std::uint32_t step = none;
        Counters counters;
        std::vector<std::uint8_t> mask;
    };
    mutable Wrong wrong_;
    mutable Times times_;
};

extern template class Session<2>;
extern template class Session<3>;

/// The cell that the last step projected; none at step 0, for orders of primitives, and when flying.
template <int D>
std::uint32_t last_cell(const Session<D>& session) {
    return session.position() > 0 && !session.flying()
               ? id_of(session.timeline().steps[session.position() - 1].item, Kind::cell)
               : none;
}

/// What the method calls the key of a cell: the first of its fields.
template <int D>
std::string_view key_title(const Session<D>& session) {
    const auto fields = session.traversal().fields();
    return fields.empty() ? "key" : fields.front().title;
}

/// The first of the cells that a run starts from; none for other methods.
template <int D>
std::uint32_t seed_cell(const Session<D>& session) {
    const auto seeds = session.traversal().seeds();
    return seeds.empty() ? none : id_of(seeds.front(), Kind::cell);
}

/// Both views and what of them is frozen, at once; the traversal is made again where the culling view is another one.
template <int D>
void set_views(Session<D>& session, const ViewSpec<D>& culling, const ViewSpec<D>& display, Frozen frozen) {
    session.unfreeze();
    if (session.culling_view() != culling) session.set_view(culling);
    if (frozen == Frozen::nothing) return;
    session.freeze();  // as a whole: the display view must not take the culling view along
    session.set_view(display);
    session.freeze(frozen);
}

/// A copy at a recorded step, or at the last one where there are fewer, wherever a budget in milliseconds ended the
/// run.
template <int D>
Session<D> copy_at(const Session<D>& session, std::uint32_t step) {
    Session<D> copy = session;
    copy.set_time_stop(none);
    copy.seek(std::min(step, session.recorded()));
    return copy;
}

}  // namespace sightline
