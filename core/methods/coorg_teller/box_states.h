// What the occluders of one eye do to each box of a tree, and what of that holds for the next eye.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/coorg_teller/choose_occluders.h"
#include "core/methods/coorg_teller/joint_test.h"

namespace sightline {

/// What hides: single polygons (Coorg and Teller), or convex groups of them (Hudson et al.).
enum class OccluderKind : std::uint8_t { polygon, convex };

/// CT's TestOcclusion.
enum class BoxState : std::uint8_t { visible, partial, invisible };

/// What testing cost; sums over all boxes of a frame.
struct Effort {
    std::uint64_t boxes = 0;     ///< that were asked for
    std::uint64_t kept = 0;      ///< of those, known from an earlier frame
    std::uint64_t tested = 0;    ///< pairs of occluder and box for which planes were looked at
    std::uint64_t reused = 0;    ///< pairs known from an earlier frame, in boxes that were not
    std::uint64_t products = 0;  ///< planes looked at: one or two inner products each
    std::uint64_t changed = 0;   ///< boxes whose state is another than the last time they were asked for

    void operator+=(const Effort& other) {
        boxes += other.boxes;
        kept += other.kept;
        tested += other.tested;
        reused += other.reused;
        products += other.products;
        changed += other.changed;
    }
};

/// An occluder keeps its slot as long as it is chosen and the eye sees the same polygons of it; its key is new
/// whenever it is not the one that was in the slot before.
struct Slot {
    bool used = false;
    std::uint32_t key = 0;
};

/// What is known of an occluder and a box until the eye has gone as far as `until`.
struct KnownRelation {
    std::uint32_t slot = 0, key = 0;
    double until = 0;
    Region region = Region::visible;
    bool beyond = false;
};

/// Working memory of one thread.
template <int D>
struct BoxScratch {
    JointScratch joint;
    std::vector<KnownRelation> now;
    std::vector<Partial> partial;
    std::vector<Vec<D>> corners;
    std::vector<std::pair<std::uint32_t, bool>> polygons;  ///< of a leaf, and whether they are hidden
};

template <int D>
class BoxStates {
public:
    /// Another eye. What is kept of earlier ones: coherence=on. `count`: the most occluders.
    void begin(std::shared_ptr<const Prepared<D>> prepared, const Problem<D>& problem, OccluderKind kind,
               std::size_t count);

    /// The state of a box with respect to the occluders that hide a part of the box around it. Different boxes that are
    /// not one in another may be asked for at the same time, when those around them have been.
    BoxState state(std::uint32_t node, Effort& effort, BoxScratch<D>& scratch);

    /// Whether the occluders that hide a part of a leaf hide a polygon of it altogether. `place`: of one of its
    /// primitives in the tree. The leaf's state is PARTIAL and has been asked for.
    bool hides_polygon(std::uint32_t leaf, std::uint32_t place, Effort& effort, BoxScratch<D>& scratch);

    /// Made anew.
    std::vector<Candidate> potential() const { return potential_occluders(*prepared_, *scene_, view_); }
    /// By slot; those of slots that are not used have no polygons.
    std::span<const Shadow<D>> shadows() const { return shadows_; }
    Connected connected() const { return connected_; }

    /// The occluders that are tested against the box, as slots: those that hide a part of each box around it. Made
    /// anew, without what is kept.
    std::vector<std::uint32_t> tested_for(std::uint32_t node) const;
    /// Those of `slots` that hide the box: one, or several together; empty: none does.
    std::vector<std::uint32_t> hiding(std::uint32_t node, std::span<const std::uint32_t> slots) const;
    Relation relation_to(std::uint32_t node, std::uint32_t slot) const;
    EyeBox<D> seen(std::uint32_t node) const { return {prepared_->tree.boxes.nodes[node].box, view_.eye}; }
    /// The same of a polygon; `slots` are those that hide a part of its leaf.
    std::vector<std::uint32_t> hiding_polygon(std::uint32_t polygon, std::span<const std::uint32_t> slots) const;

    Effort& effort() { return effort_; }
    const Effort& effort() const { return effort_; }

private:
    struct Record {
        std::uint32_t epoch = 0;    ///< of the frame for which it was last found to hold
        std::uint32_t asked = 0;    ///< version of the occluders that it was made with
        std::uint32_t version = 1;  ///< of those that hide a part of it
        std::uint32_t hidden_by = none;
        double until = -1;
        BoxState state = BoxState::visible;
        bool made = false;
        std::vector<KnownRelation> known;  ///< by slot
    };

    /// Of a polygon in a leaf, by the place of its primitive.
    struct PolygonRecord {
        std::uint32_t asked = 0;  ///< version of the occluders that it was made with
        std::uint32_t hidden_by = none, key = 0;
        bool hidden = false;
        double until = -1;
    };

    /// A copy starts without what it could save: no two write the same memory.
    struct Kept {
        Kept() = default;
        Kept(const Kept& other) : boxes(other.boxes.size()) {}
        Kept& operator=(const Kept&) = delete;

        std::vector<Record> boxes;
        std::vector<PolygonRecord> polygons;  ///< coherence=on
    };

    void place(const OccluderLists& occluders);
    template <typename Occludee>
    std::vector<std::uint32_t> hiding_of(const Occludee& occludee, std::span<const std::uint32_t> slots) const;
    void make(std::uint32_t node, Record& record, Effort& effort, BoxScratch<D>& scratch);
    template <typename Each>
    void for_asked(std::uint32_t node, Each each) const;
    std::uint32_t asked_version(std::uint32_t node) const;
    double until(double slack) const { return travelled_ + slack * (1 - 0x1p-40); }

    std::shared_ptr<const Prepared<D>> prepared_;
    const Scene<D>* scene_ = nullptr;
    View<D> view_;
    OccluderKind kind_ = OccluderKind::polygon;
    Connected connected_ = Connected::off;
    bool keeps_ = true;
    double travelled_ = 0;  ///< by the eye, since there is anything kept
    std::uint32_t epoch_ = 0, version_ = 0, next_key_ = 0;
    std::vector<Slot> slots_;
    std::vector<Shadow<D>> shadows_;
    Meetings meetings_;
    Kept kept_;
    Effort effort_;
};

extern template class BoxStates<2>;
extern template class BoxStates<3>;

}  // namespace sightline
