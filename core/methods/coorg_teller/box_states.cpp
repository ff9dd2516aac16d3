// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/box_states.h"

#include <algorithm>

#include "core/methods/coorg_teller/fusion.h"
#include "core/methods/coorg_teller/occluder_region.h"

namespace sightline {

namespace {

/// The occluders that hide the box, or the polygon, together; empty: none do, or nobody asks.
template <int D, typename Occludee>
std::vector<std::uint32_t> hiding_set(std::span<const Shadow<D>> shadows, std::span<const Partial> partial,
                                      const Meetings& meetings, Connected how, const Occludee& occludee,
                                      JointScratch& scratch, double& slack, std::uint64_t& products) {
    if (how == Connected::off || partial.size() < 2) return {};
    if constexpr (D == 2)
        if (how == Connected::fused) return fused_set(shadows, partial, corners_of(occludee), occludee.eye, slack);
    return joint_set(partial, meetings, how == Connected::fused ? Connected::grow : how, scratch, slack,
                     [&](std::uint32_t shadow, std::uint32_t side) {
                         ++products;
                         const auto [satisfied, holds] = supporting_plane(shadows[shadow].sides[side], occludee);
                         return SideSaid{satisfied, holds};
                     });
}

template <int D>
Partial partial_of(std::span<const Shadow<D>> shadows, std::uint32_t slot, bool beyond) {
    return {slot, static_cast<std::uint32_t>(shadows[slot].sides.size()), beyond};
}

}  // namespace

template <int D>
void BoxStates<D>::begin(std::shared_ptr<const Prepared<D>> prepared, const Problem<D>& problem, OccluderKind kind,
                         std::size_t count) {
    // Convex occluders are sets already, and their method has no such parameter.
    const auto connected =
        kind == OccluderKind::polygon ? problem.parameters.template choice<Connected>(connected_row()) : Connected::off;
    const bool keeps = problem.parameters.template choice<Coherence>(coherence_row()) == Coherence::on;
    const std::size_t boxes = prepared->tree.boxes.nodes.size();
    if (keeps != keeps_ || kind != kind_ || connected != connected_ || prepared != prepared_ ||
        scene_ != problem.scene || kept_.boxes.size() != boxes || epoch_ == none) {
        kept_.boxes.assign(boxes, {});
        kept_.polygons.clear();
        slots_.clear();
        travelled_ = 0;
        epoch_ = version_ = next_key_ = 0;
    } else {
        const Vec<D> way = problem.view.eye - view_.eye;
        travelled_ += std::sqrt(glm::dot(way, way)) * (1 + 0x1p-40);
        if (!keeps) slots_.clear();
    }
    if (keeps && kept_.polygons.empty() && problem.parameters.template choice<Leaves>(leaves_row()) == Leaves::polygons)
        kept_.polygons.resize(prepared->tree.boxes.primitives.size());
    keeps_ = keeps;
    kind_ = kind;
    prepared_ = std::move(prepared);
    scene_ = problem.scene;
    view_ = problem.view;
    connected_ = connected;
    ++epoch_;
    effort_ = {};
    // Convex occluders are grown out of a few more polygons than there will be of them.
    constexpr std::size_t polygons_each = 16;
    if (kind == OccluderKind::polygon)
        place(single_occluders(potential_occluders(*prepared_, *scene_, view_, count)));
    else
        place(convex_occluders(*prepared_, *scene_, view_.eye,
                               potential_occluders(*prepared_, *scene_, view_, count * polygons_each), count));
    if (connected_ != Connected::off) meetings_.find<D>(shadows_);
}

/// Gives each occluder a slot: its own, or one that is free.
template <int D>
void BoxStates<D>::place(const OccluderLists& occluders) {
    std::vector<std::uint32_t> slot_of(occluders.size(), none);
    std::vector<std::uint8_t> kept(slots_.size());
    for (std::size_t i = 0; i < occluders.size(); ++i)
        for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
            if (slots_[slot].used && !kept[slot] && shadows_[slot].polygons == occluders[i]) {
                slot_of[i] = slot;
                kept[slot] = 1;
                break;
            }
    bool other = slots_.empty();
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot) {
        other |= slots_[slot].used && !kept[slot];
        slots_[slot].used = kept[slot];
    }
    std::uint32_t free = 0;
    for (std::uint32_t& slot : slot_of) {
        if (slot != none) continue;
        while (free < slots_.size() && slots_[free].used) ++free;
        if (free == slots_.size()) slots_.emplace_back();
        slots_[free] = {true, ++next_key_};
        slot = free;
        other = true;
    }
    shadows_.resize(slots_.size());
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
        if (!slots_[slot].used) shadows_[slot] = {};
    const auto sides_seen = [](const Shadow<D>& shadow) {
        std::vector<bool> behind;
        for (const ShadowFront<D>& front : shadow.fronts) behind.push_back(front.from_behind);
        return behind;
    };
    const Polygons<D>& polygons = prepared_->polygons;
    for (std::size_t i = 0; i < occluders.size(); ++i) {
        Shadow<D>& shadow = shadows_[slot_of[i]];
        const std::vector<bool> before = sides_seen(shadow);
        make_shadow<D>(*scene_, polygons, occluders[i], view_.eye, shadow);
        const std::uint32_t largest = occluders[i].front();
        shadow.area_angle = std::abs(area_angle<D>(polygons.area[largest], polygons.centre[largest], view_.eye));
        // The other side of a polygon is another occluder.
        if (sides_seen(shadow) != before) {
            slots_[slot_of[i]].key = ++next_key_;
            other = true;
        }
    }
    version_ += other;
}

template <int D>
std::uint32_t BoxStates<D>::asked_version(std::uint32_t node) const {
    const std::uint32_t parent = prepared_->tree.parent[node];
    return parent == none ? version_ : kept_.boxes[parent].version;
}

/// Calls `each(slot)` for the occluders that the box is tested against, while it returns true.
template <int D>
template <typename Each>
void BoxStates<D>::for_asked(std::uint32_t node, Each each) const {
    const std::uint32_t parent = prepared_->tree.parent[node];
    if (parent == none) {
        for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
            if (slots_[slot].used && !each(slot)) return;
    } else {
        for (const KnownRelation& known : kept_.boxes[parent].known)
            if (known.region == Region::partial && !each(known.slot)) return;
    }
}

template <int D>
BoxState BoxStates<D>::state(std::uint32_t node, Effort& effort, BoxScratch<D>& scratch) {
    Record& record = kept_.boxes[node];
    if (record.epoch == epoch_) return record.state;
    // Those around it first, where nobody has asked for them at this eye: after going back in a recording.
    if (const std::uint32_t parent = prepared_->tree.parent[node];
        parent != none && kept_.boxes[parent].epoch != epoch_)
        state(parent, effort, scratch);
    ++effort.boxes;
    if (record.made && keeps_ && record.asked == asked_version(node) && travelled_ < record.until)
        ++effort.kept;
    else
        make(node, record, effort, scratch);
    record.epoch = epoch_;
    return record.state;
}

template <int D>
void BoxStates<D>::make(std::uint32_t node, Record& record, Effort& effort, BoxScratch<D>& scratch) {
    const EyeBox<D> box = seen(node);
    const BoxState before = record.state;
    const bool was_made = record.made && keeps_;
    record.asked = asked_version(node);
    record.made = true;
    std::size_t at = 0;  // among what was known, which is by slot as well
    const auto find_known = [&](std::uint32_t slot) -> const KnownRelation* {
        while (at < record.known.size() && record.known[at].slot < slot) ++at;
        if (at == record.known.size() || record.known[at].slot != slot) return nullptr;
        const KnownRelation& known = record.known[at];
        return known.key == slots_[slot].key && travelled_ < known.until && keeps_ ? &known : nullptr;
    };
    const auto test = [&](std::uint32_t slot) {
        ++effort.tested;
        const Relation found = relation(shadows_[slot], *scene_, box, effort.products);
        return KnownRelation{slot, slots_[slot].key, until(found.slack), found.region, found.beyond};
    };
    // What hid it the last time first: one look may do.
    if (keeps_ && record.hidden_by != none && record.hidden_by < slots_.size() && slots_[record.hidden_by].used) {
        bool is_asked = false;
        for_asked(node, [&](std::uint32_t slot) {
            is_asked |= slot == record.hidden_by;
            return slot < record.hidden_by;
        });
        if (is_asked) {
            const KnownRelation known = test(record.hidden_by);
            if (known.region == Region::hidden) {
                record.until = known.until;
                record.state = BoxState::invisible;
                effort.changed += was_made && before != record.state;
                return;
            }
        }
    }
    std::vector<KnownRelation>& now = scratch.now;
    now.clear();
    double until_all = std::numeric_limits<double>::infinity();
    bool any_partial = false;
    std::uint32_t hider = none;
    for_asked(node, [&](std::uint32_t slot) {
        const KnownRelation* const old = find_known(slot);
        effort.reused += old != nullptr;
        now.push_back(old ? *old : test(slot));
        const KnownRelation& known = now.back();
        if (known.region == Region::hidden) {
            hider = slot;
            record.until = known.until;
            return false;
        }
        any_partial |= known.region == Region::partial;
        until_all = std::min(until_all, known.until);
        return true;
    });
    record.hidden_by = hider;
    if (hider != none) {
        record.state = BoxState::invisible;
    } else {
        record.state = any_partial ? BoxState::partial : BoxState::visible;
        record.until = until_all;
        if (any_partial && connected_ != Connected::off) {
            scratch.partial.clear();
            for (const KnownRelation& known : now)
                if (known.region == Region::partial)
                    scratch.partial.push_back(partial_of<D>(shadows_, known.slot, known.beyond));
            double slack = std::numeric_limits<double>::infinity();
            if (!hiding_set<D>(shadows_, scratch.partial, meetings_, connected_, box, scratch.joint, slack,
                               effort.products)
                     .empty())
                record.state = BoxState::invisible;
            record.until = std::min(record.until, until(slack));
        }
    }
    effort.changed += was_made && before != record.state;
    // The children hear of it where other occluders are left for them.
    const auto same = [&] {
        const auto next_partial = [](const std::vector<KnownRelation>& all, std::size_t from) {
            while (from < all.size() && all[from].region != Region::partial) ++from;
            return from;
        };
        std::size_t i = next_partial(now, 0), j = next_partial(record.known, 0);
        while (i < now.size() && j < record.known.size() && now[i].slot == record.known[j].slot &&
               now[i].key == record.known[j].key) {
            i = next_partial(now, i + 1);
            j = next_partial(record.known, j + 1);
        }
        return i == now.size() && j == record.known.size();
    };
    if (!same()) ++record.version;
    record.known.assign(now.begin(), now.end());
}

template <int D>
std::vector<std::uint32_t> BoxStates<D>::tested_for(std::uint32_t node) const {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
        if (slots_[slot].used) slots.push_back(slot);
    std::vector<std::uint32_t> around;
    for (std::uint32_t at = prepared_->tree.parent[node]; at != none; at = prepared_->tree.parent[at])
        around.push_back(at);
    for (std::size_t i = around.size(); i-- > 0;)
        std::erase_if(slots,
                      [&](std::uint32_t slot) { return relation_to(around[i], slot).region != Region::partial; });
    return slots;
}

template <int D>
Relation BoxStates<D>::relation_to(std::uint32_t node, std::uint32_t slot) const {
    std::uint64_t products = 0;
    return relation(shadows_[slot], *scene_, seen(node), products);
}

template <int D>
template <typename Occludee>
std::vector<std::uint32_t> BoxStates<D>::hiding_of(const Occludee& occludee,
                                                   std::span<const std::uint32_t> slots) const {
    std::vector<Partial> partial;
    std::uint64_t products = 0;
    for (const std::uint32_t slot : slots) {
        const Relation found = relation(shadows_[slot], *scene_, occludee, products);
        if (found.region == Region::hidden) return {slot};
        if (found.region == Region::partial) partial.push_back(partial_of<D>(shadows_, slot, found.beyond));
    }
    JointScratch scratch;
    double slack = 0;
    std::vector<std::uint32_t> set =
        hiding_set<D>(shadows_, partial, meetings_, connected_, occludee, scratch, slack, products);
    for (std::uint32_t& member : set) member = partial[member].shadow;
    return set;
}

template <int D>
std::vector<std::uint32_t> BoxStates<D>::hiding(std::uint32_t node, std::span<const std::uint32_t> slots) const {
    return hiding_of(seen(node), slots);
}

template <int D>
std::vector<std::uint32_t> BoxStates<D>::hiding_polygon(std::uint32_t polygon,
                                                        std::span<const std::uint32_t> slots) const {
    const std::vector<Vec<D>> corners = prepared_->polygons.corners_of(polygon);
    return hiding_of(EyePolygon<D>(corners, view_.eye), slots);
}

template <int D>
bool BoxStates<D>::hides_polygon(std::uint32_t leaf, std::uint32_t place, Effort& effort, BoxScratch<D>& scratch) {
    const Record& record = kept_.boxes[leaf];
    PolygonRecord unkept;
    PolygonRecord& known = kept_.polygons.empty() ? unkept : kept_.polygons[place];
    const bool still_chosen =
        known.hidden_by < slots_.size() && slots_[known.hidden_by].used && slots_[known.hidden_by].key == known.key;
    // One that hides it alone does so whoever else is there.
    if (travelled_ < known.until && (known.hidden_by != none ? still_chosen : known.asked == record.version)) {
        ++effort.reused;
        return known.hidden;
    }
    const std::uint32_t polygon = prepared_->polygons.polygon_of[prepared_->tree.boxes.primitives[place]];
    scratch.corners.clear();
    for (const auto& side : prepared_->polygons.sides_of(polygon))
        scratch.corners.push_back(prepared_->polygons.points[side.point]);
    const EyePolygon<D> seen(scratch.corners, view_.eye);
    known = {record.version, none, 0, false, std::numeric_limits<double>::infinity()};
    scratch.partial.clear();
    for (const KnownRelation& asked : record.known) {
        if (asked.region != Region::partial) continue;
        ++effort.tested;
        const Relation found = relation(shadows_[asked.slot], *scene_, seen, effort.products);
        if (found.region == Region::hidden) {
            known = {record.version, asked.slot, asked.key, true, until(found.slack)};
            return true;
        }
        known.until = std::min(known.until, until(found.slack));
        if (found.region == Region::partial)
            scratch.partial.push_back(partial_of<D>(shadows_, asked.slot, found.beyond));
    }
    double slack = std::numeric_limits<double>::infinity();
    known.hidden =
        !hiding_set<D>(shadows_, scratch.partial, meetings_, connected_, seen, scratch.joint, slack, effort.products)
             .empty();
    known.until = std::min(known.until, until(slack));
    return known.hidden;
}

template class BoxStates<2>;
template class BoxStates<3>;

}  // namespace sightline
