// What a run of Visible says of itself.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/methods/coorg_teller/box_planes.h"
#include "core/methods/coorg_teller/occluder_region.h"
#include "core/methods/coorg_teller/visible_run.h"

namespace sightline {

namespace {

constexpr std::size_t most_named = 4;

template <int D>
std::string_view primitive_word() {
    return D == 2 ? "segment" : "triangle";
}

/// "triangles 4 and 5"
template <int D>
std::string members_words(const Polygons<D>& polygons, std::span<const std::uint32_t> of) {
    std::vector<std::uint32_t> primitives;
    for (const std::uint32_t polygon : of) {
        const auto members = polygons.members_of(polygon);
        primitives.insert(primitives.end(), members.begin(), members.end());
    }
    return some_of(std::string(primitive_word<D>()), primitives, most_named);
}

}  // namespace

template <int D>
std::string VisibleRun<D>::popped_words(const Step& step) const {
    return step.item ? Run<D>::popped_words(step) : "the rest of a leaf";
}

/// "it is INVISIBLE: it lies in the shadow of triangles 4 and 5: …"
template <int D>
std::string VisibleRun<D>::occluders_words(std::span<const std::uint32_t> slots) const {
    std::vector<std::uint32_t> polygons;
    for (const std::uint32_t slot : slots)
        polygons.insert(polygons.end(), states_.shadows()[slot].polygons.begin(),
                        states_.shadows()[slot].polygons.end());
    const std::string who = members_words<D>(prepared_->polygons, polygons);
    if (slots.size() > 1)
        return "it is INVISIBLE: " + who + " hide it together, though none does alone: all supporting planes through " +
               (states_.connected() == Connected::fused ? "the ends of their fused shadows" : "silhouette edges") +
               " are satisfied";
    return "it is INVISIBLE: it lies in the shadow of " + who + ": all supporting planes are satisfied";
}

/// Of a polygon that was left out of a leaf that is drawn.
template <int D>
Verdict VisibleRun<D>::why_left_out(std::uint32_t primitive) const {
    if (!by_polygons_ || this->drawn_.has(primitive)) return {};
    for (std::uint32_t node = 0; node < tree_->nodes.size(); ++node) {
        if (marks_[node].stamp != static_cast<std::uint32_t>(VisibleRule::leaf)) continue;
        const auto held = tree_->primitives_of(node);
        if (std::find(held.begin(), held.end(), primitive) == held.end()) continue;
        std::vector<std::uint32_t> slots = states_.tested_for(node);
        std::erase_if(slots,
                      [&](std::uint32_t slot) { return states_.relation_to(node, slot).region != Region::partial; });
        const auto hiding = states_.hiding_polygon(prepared_->polygons.polygon_of[primitive], slots);
        if (!hiding.empty()) return {"hidden", occluders_words(hiding)};
    }
    return {};
}

template <int D>
Verdict VisibleRun<D>::why_not(const Item& item) const {
    if (item.kind == Kind::cell) return {"no-cells", "the method walks a tree of boxes, not cells"};
    if (item.kind == Kind::primitive) return why_left_out(item.id);
    if (item.kind != Kind::node) return {};
    const CellState state = marks_[item.id].state;
    if (state == CellState::unseen)
        return {"outside-view", "it lies outside the view: switched off, nothing is tested"};
    if (state == CellState::hidden)
        return {"hidden", occluders_words(states_.hiding(item.id, states_.tested_for(item.id)))};
    if (state != CellState::clean) return {};
    std::uint32_t above = item.id;
    while (above != 0 && marks_[above].state == CellState::clean) above = prepared_->tree.parent[above];
    const Item box{above, Kind::node};
    const std::string lies = "it lies in " + item_name(box);
    switch (marks_[above].state) {
        case CellState::unseen:
            return {"outside-view", lies + ", which lies outside the view", box};
        case CellState::hidden:
            return {"hidden", lies + ", which is INVISIBLE", box};
        case CellState::projected:
            return {"drawn-whole", lies + ", which is VISIBLE and drawn whole", box};
        default:
            return {"waits", lies + ", which waits", box};
    }
}

template <int D>
Verdict VisibleRun<D>::why_drawn(const Item& item) const {
    if (item.kind != Kind::node || marks_[item.id].state != CellState::projected) return {};
    const auto slots = states_.tested_for(item.id);
    const std::uint32_t best = best_occluder(states_, item.id, slots);
    if (best == none)
        return {"visible", item.id == 0 ? "it is VISIBLE: there is no occluder"
                                        : "it is VISIBLE: no occluder hides a part of the box around it"};
    const Shadow<D>& shadow = states_.shadows()[best];
    const std::string who = members_words<D>(prepared_->polygons, shadow.polygons);
    const bool many = who.find(' ') != who.rfind(' ');
    const bool hides_part = states_.relation_to(item.id, best).region == Region::partial;
    std::string text = hides_part ? "it is PARTIAL: " + who + (many ? " hide" : " hides") + " the most of it, but "
                                  : "it is VISIBLE: even " + who + (many ? " hide" : " hides") + " nothing of it, as ";
    const PlaneKind decides = hides_part ? PlaneKind::supporting : PlaneKind::separating;
    for (const TestedPlane<D>& plane : box_planes(shadow, prepared_->polygons, *this->problem_.scene,
                                                  tree_->nodes[item.id].box, this->problem_.view.eye)) {
        if (plane.satisfied) continue;
        if (plane.kind == PlaneKind::own && hides_part)
            return {"partial", text + "a part of the box lies before its plane"};
        if (plane.kind == decides)
            return {hides_part ? "partial" : "visible",
                    text + "the " + std::string(plane_kind_words[static_cast<std::size_t>(decides)]) +
                        (D == 2 ? " line through end " : " plane through edge ") + std::to_string(plane.edge) +
                        " is not satisfied: the eye is " + short_number(-plane.distance) + " outside"};
    }
    if (!hides_part) return {"visible", text + "no part of the box lies beyond its plane"};
    return {"partial", text + "a plane through its edges is not satisfied"};
}

template <int D>
std::vector<OccluderFact> VisibleRun<D>::occluders() const {
    const Polygons<D>& polygons = prepared_->polygons;
    std::vector<OccluderFact> all;
    std::vector<std::uint32_t> actual;
    for (const Shadow<D>& shadow : states_.shadows()) {
        if (shadow.polygons.empty()) continue;
        OccluderFact fact{{}, shadow.area_angle, true};
        for (const std::uint32_t polygon : shadow.polygons) {
            const auto members = polygons.members_of(polygon);
            fact.primitives.insert(fact.primitives.end(), members.begin(), members.end());
            actual.push_back(polygon);
        }
        all.push_back(std::move(fact));
    }
    std::sort(actual.begin(), actual.end());
    for (const Candidate& candidate : states_.potential()) {
        if (std::binary_search(actual.begin(), actual.end(), candidate.polygon)) continue;
        const auto members = polygons.members_of(candidate.polygon);
        all.push_back({{members.begin(), members.end()}, candidate.area_angle, false});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const OccluderFact& a, const OccluderFact& b) { return a.area_angle > b.area_angle; });
    return all;
}

template <int D>
std::vector<TestedPlane<D>> VisibleRun<D>::tested_planes(const Item& box, std::uint32_t primitive) const {
    if (box.kind != Kind::node) return {};
    const Scene<D>& scene = *this->problem_.scene;
    const Vec<D>& eye = this->problem_.view.eye;
    const auto planes_to = [&](const Shadow<D>& shadow) {
        return box_planes(shadow, prepared_->polygons, scene, tree_->nodes[box.id].box, eye);
    };
    std::uint32_t slot = none;
    if (primitive == none) {
        const auto slots = states_.tested_for(box.id);
        if (const auto hiding = states_.hiding(box.id, slots); hiding.size() > 1) {
            // What is asked of the set: neither the edges that its members share, nor separating planes.
            auto planes = planes_to(joint_shadow(states_, prepared_->polygons, scene, hiding, eye));
            std::erase_if(planes, [](const TestedPlane<D>& plane) { return plane.kind == PlaneKind::separating; });
            return planes;
        }
        slot = best_occluder(states_, box.id, slots);
    } else {
        const std::uint32_t polygon = prepared_->polygons.polygon_of[primitive];
        for (std::uint32_t i = 0; i < states_.shadows().size(); ++i) {
            const auto& of = states_.shadows()[i].polygons;
            if (std::find(of.begin(), of.end(), polygon) != of.end()) slot = i;
        }
    }
    if (slot == none) return {};
    return planes_to(states_.shadows()[slot]);
}

template <int D>
std::vector<TestedOccluder> VisibleRun<D>::tested_occluders(const Item& box) const {
    if (box.kind != Kind::node || marks_[box.id].state == CellState::unseen) return {};
    std::vector<std::uint32_t> slots = states_.tested_for(box.id);
    std::stable_sort(slots.begin(), slots.end(), [&](std::uint32_t a, std::uint32_t b) {
        return states_.shadows()[a].area_angle > states_.shadows()[b].area_angle;
    });
    const std::vector<std::uint32_t> hiding = states_.hiding(box.id, slots);
    std::vector<TestedOccluder> all;
    for (const std::uint32_t slot : slots) {
        TestedOccluder& occluder = all.emplace_back();
        for (const std::uint32_t polygon : states_.shadows()[slot].polygons) {
            const auto members = prepared_->polygons.members_of(polygon);
            occluder.primitives.insert(occluder.primitives.end(), members.begin(), members.end());
        }
        const Region region = states_.relation_to(box.id, slot).region;
        occluder.region = static_cast<std::uint8_t>(region);
        occluder.hides = std::find(hiding.begin(), hiding.end(), slot) != hiding.end();
        occluder.handed_on = hiding.empty() && region != Region::visible;
    }
    return all;
}

template <int D>
std::optional<Box<D>> VisibleRun<D>::eye_box() const {
    const Tree<D>& space = prepared_->tree.space;
    const Vec<D>& eye = this->problem_.view.eye;
    if (space.nodes.empty() || !space.root_box().contains(eye)) return std::nullopt;
    return space.nodes[space.leaves[space.leaf_at(eye)]].box;
}

template <int D>
std::optional<OccluderRegion<D>> VisibleRun<D>::occluder_region(std::uint32_t primitive) const {
    constexpr int points = 49;
    const Polygons<D>& polygons = prepared_->polygons;
    const std::uint32_t polygon = polygons.polygon_of[primitive];
    const Vec<D>&area = polygons.area[polygon], &centre = polygons.centre[polygon];
    if (glm::dot(area, area) == 0) return std::nullopt;
    const bool both = polygons.two_sided[polygon];
    OccluderRegion<D> region{{}, sightline::occluder_region(area, centre, prepared_->threshold, both)};
    std::vector<Vec<D>> across;
    if constexpr (D == 2) {
        across.push_back({-area.y, area.x});
    } else {
        // Two sections, along an edge and across it.
        const std::vector<Vec<D>> corners = polygons.corners_of(polygon);
        across.push_back(corners[1] - corners[0]);
        across.push_back(glm::cross(area, across[0]));
    }
    for (const Vec<D>& along : across) {
        region.outlines.push_back(region_outline(area, centre, prepared_->threshold, along, points));
        if (both) region.outlines.push_back(region_outline(-area, centre, prepared_->threshold, along, points));
    }
    return region;
}

template <int D>
std::vector<CodeLine> VisibleRun<D>::code(const CodePlace& at) const {
    const bool in_step = at.in_step(), testing = in_step && *at.substep == 0;
    VisibleRule rule = VisibleRule::waits;
    std::string popped;
    if (at.step && at.step->item.kind == Kind::node) {
        popped = item_name(at.step->item);
        for (const Change& change : at.changes)
            if (change.item() == at.step->item && change.rule != static_cast<std::uint8_t>(VisibleRule::waits))
                rule = VisibleRule{change.rule};
    }
    const auto is = [&](VisibleRule wanted) { return in_step && !testing && rule == wanted; };
    std::vector<CodeLine> lines;
    const auto add = [&](std::string text, int indent, bool lit, std::string values, std::string source) {
        lines.push_back({std::move(text), indent, lit, lit ? std::move(values) : std::string(), std::move(source)});
    };
    const auto shadows = std::count_if(states_.shadows().begin(), states_.shadows().end(),
                                       [](const Shadow<D>& shadow) { return !shadow.polygons.empty(); });
    const bool starts = !in_step && this->steps_ == 0;
    add("S = the " + std::string(kind_ == OccluderKind::polygon ? "k polygons" : "convex occluders") +
            " with the largest area-angle",
        0, starts,
        starts ? std::to_string(shadows) + " of " + counted(states_.potential().size(), "potential occluder") : "",
        "CT 3.3");
    add("while a box waits:", 0, !in_step && this->steps_ > 0 && !this->finished(),
        counted(this->counters_.front_size, "node") + (this->counters_.front_size == 1 ? " waits" : " wait"), "");
    add("T = the next one, depth first", 1, testing, popped, "CT 3, Visible");
    add("outside the view: switch it off", 1, is(VisibleRule::outside), popped, "CT 3.1");
    add("all supporting planes of an occluder in S satisfied, or", 1, false, {}, "CT 2.1, TestOcclusion");
    add("those of a connected set: INVISIBLE, drop it", 1, is(VisibleRule::invisible), popped, "CT 2.1, Definition 1");
    add("no occluder's separating planes all satisfied: VISIBLE, Gather", 1,
        is(VisibleRule::gathered) || is(VisibleRule::looked_at), counted(at.rendered, "primitive") + " of " + popped,
        "CT 3, Visible");
    add("PARTIAL and a leaf: Gather", 1, is(VisibleRule::leaf), counted(at.rendered, "primitive") + " of " + popped,
        "CT 3, Visible");
    add("PARTIAL: S' = those whose separating planes are satisfied;", 1, false, {}, "CT 3, Visible");
    add("Visible(S', T') for each child T'", 1, is(VisibleRule::opened), popped, "CT 3, Visible");
    add("nothing waits: done", 0, !in_step && this->steps_ > 0 && this->finished(), "", "");
    if (std::none_of(lines.begin(), lines.end(), [](const CodeLine& line) { return line.lit; })) {
        lines[2].lit = true;
        lines[2].values = popped;
    }
    return lines;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                         \
    template std::string VisibleRun<D>::popped_words(const Step&) const;                                 \
    template std::string VisibleRun<D>::occluders_words(std::span<const std::uint32_t>) const;           \
    template Verdict VisibleRun<D>::why_left_out(std::uint32_t) const;                                   \
    template Verdict VisibleRun<D>::why_not(const Item&) const;                                          \
    template Verdict VisibleRun<D>::why_drawn(const Item&) const;                                        \
    template std::vector<OccluderFact> VisibleRun<D>::occluders() const;                                 \
    template std::vector<TestedPlane<D>> VisibleRun<D>::tested_planes(const Item&, std::uint32_t) const; \
    template std::vector<TestedOccluder> VisibleRun<D>::tested_occluders(const Item&) const;             \
    template std::optional<Box<D>> VisibleRun<D>::eye_box() const;                                       \
    template std::optional<OccluderRegion<D>> VisibleRun<D>::occluder_region(std::uint32_t) const;       \
    template std::vector<CodeLine> VisibleRun<D>::code(const CodePlace&) const;
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
