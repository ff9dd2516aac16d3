// Whether occluders that meet at edges hide a box together (CT section 2.1, figures 3b, 4b, 4c and 5).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/methods/coorg_teller/object_space_parameters.h"
#include "core/methods/coorg_teller/shadow.h"

namespace sightline {

/// Which sides of shadows share an edge. Of those that are asked about a box, a side is crossed to the one that runs
/// along its edge the other way as the eye sees it; where several do, each is crossed once, those of lower polygons
/// first.
class Meetings {
public:
    /// A side of a shadow.
    struct Half {
        std::uint32_t edge = none, polygon = none, shadow = none, side = 0;
        bool reversed = false;
    };

    template <int D>
    void find(std::span<const Shadow<D>> shadows);
    /// The shadow on the other side, among those for which `is_asked(shadow)`; none: the side is a silhouette.
    template <typename IsAsked>
    std::uint32_t partner(std::uint32_t shadow, std::uint32_t side, IsAsked is_asked) const;

private:
    std::vector<std::uint32_t> begin_;  ///< of a shadow's sides in group_
    std::vector<std::uint32_t> group_;  ///< where a side's edge begins in halves_
    std::vector<Half> halves_;          ///< by edge, then polygon
};

template <typename IsAsked>
std::uint32_t Meetings::partner(std::uint32_t shadow, std::uint32_t side, IsAsked is_asked) const {
    const std::uint32_t begin = group_[begin_[shadow] + side];
    std::uint32_t end = begin + 1;
    while (end < halves_.size() && halves_[end].edge == halves_[begin].edge) ++end;
    if (end == begin + 1) return none;
    if (end == begin + 2) {  // nearly always
        const Half& other = halves_[halves_[begin].shadow == shadow && halves_[begin].side == side ? begin + 1 : begin];
        const bool crosses = halves_[begin].reversed != halves_[begin + 1].reversed && other.shadow != shadow;
        return crosses && is_asked(other.shadow) ? other.shadow : none;
    }
    std::uint64_t crossed = 0;  // of the first 64 of an edge; no more are crossed
    end = std::min(end, begin + 64);
    const auto is_free = [&](std::uint32_t i) { return !(crossed >> (i - begin) & 1) && is_asked(halves_[i].shadow); };
    const auto is_own = [&](std::uint32_t i) { return halves_[i].shadow == shadow && halves_[i].side == side; };
    for (std::uint32_t a = begin; a < end; ++a) {
        if (!is_free(a)) continue;
        for (std::uint32_t b = a + 1; b < end; ++b) {
            if (halves_[b].reversed == halves_[a].reversed || halves_[b].shadow == halves_[a].shadow || !is_free(b))
                continue;
            if (is_own(a)) return halves_[b].shadow;
            if (is_own(b)) return halves_[a].shadow;
            crossed |= std::uint64_t{1} << (b - begin);
            break;
        }
        if (is_own(a)) return none;
    }
    return none;
}

/// One that hides a part of the box.
struct Partial {
    std::uint32_t shadow = 0;
    std::uint32_t sides = 0;
    bool beyond = false;  ///< as Relation has it
};

/// A supporting plane: what it says of the eye, and how far that can move before it can say something else.
struct SideSaid {
    bool satisfied = false;
    double slack = 0;
};

/// Working memory.
struct JointScratch {
    std::vector<std::uint32_t> place;  ///< of a shadow among the partial ones
    std::vector<std::uint32_t> group, todo, partners;
    std::vector<std::uint32_t> first_side;  ///< of each partial one, in what follows
    std::vector<std::optional<SideSaid>> said;
};

/// Some set of them that hides the box, as indices into `partial`, ascending; empty: none does. Only those count beyond
/// whose planes all of the box lies: they alone hide what they cover. on: maximal sets (TestOcclusion as printed, but
/// of the occluders that hide a part of the box only, since others add silhouette edges that spoil a set); grow: from
/// one to those on the other side of edges whose planes are not satisfied. Calls `say(shadow, side)` for the supporting
/// planes that it needs, once each. Lowers `slack` to how far the eye can move before the answer can be another, as
/// long as the same ones hide a part of the box.
///
/// Why it is safe: each edge is satisfied, or crossed by two of them in opposite directions. So seen from the eye the
/// border of the set runs round each point of the box counter-clockwise, and it is covered at least once (a closed
/// surface round the eye covers all), by an occluder that the box lies beyond.
template <typename Say>
std::vector<std::uint32_t> joint_set(std::span<const Partial> partial, const Meetings& meetings, Connected how,
                                     JointScratch& scratch, double& slack, Say say) {
    auto& place = scratch.place;
    auto& group = scratch.group;
    auto& todo = scratch.todo;
    auto& partners = scratch.partners;
    auto& first_side = scratch.first_side;
    auto& said = scratch.said;
    first_side.clear();
    std::uint32_t sides = 0;
    for (std::uint32_t i = 0; i < partial.size(); ++i) {
        if (place.size() <= partial[i].shadow) place.resize(partial[i].shadow + 1, none);
        if (partial[i].beyond) place[partial[i].shadow] = i;
        first_side.push_back(sides);
        sides += partial[i].sides;
    }
    const auto is_asked = [&](std::uint32_t shadow) { return shadow < place.size() && place[shadow] != none; };
    bool any_meet = false;
    partners.assign(sides, none);
    for (std::uint32_t i = 0; i < partial.size(); ++i) {
        if (!partial[i].beyond) continue;
        for (std::uint32_t side = 0; side < partial[i].sides; ++side) {
            const std::uint32_t shadow = meetings.partner(partial[i].shadow, side, is_asked);
            if (shadow != none) partners[first_side[i] + side] = place[shadow];
            any_meet |= shadow != none;
        }
    }
    for (const Partial& p : partial) place[p.shadow] = none;
    if (!any_meet) return {};

    said.clear();
    said.resize(sides);
    const auto ask = [&](std::uint32_t i, std::uint32_t side) {
        std::optional<SideSaid>& known = said[first_side[i] + side];
        if (!known) known = say(partial[i].shadow, side);
        return *known;
    };
    // Alone none of them hides it; so one that meets no other is no set.
    const auto meets_any = [&](std::uint32_t i) {
        const auto begin = partners.begin() + first_side[i];
        return std::any_of(begin, begin + partial[i].sides, [](std::uint32_t other) { return other != none; });
    };
    group.assign(partial.size(), none);
    for (std::uint32_t start = 0; start < partial.size(); ++start) {
        if (!partial[start].beyond || !meets_any(start)) continue;
        if (how == Connected::on && group[start] != none) continue;
        bool hides = true;
        double holds = std::numeric_limits<double>::infinity();
        todo.assign(1, start);
        group[start] = start;
        const auto add = [&](std::uint32_t other) {
            if (std::exchange(group[other], start) != start) todo.push_back(other);
        };
        if (how == Connected::on)  // who is in the set does not depend on what planes say
            for (std::size_t next = 0; next < todo.size(); ++next)
                for (std::uint32_t side = 0; side < partial[todo[next]].sides; ++side)
                    if (const std::uint32_t other = partners[first_side[todo[next]] + side]; other != none) add(other);
        for (std::size_t next = 0; next < todo.size() && hides; ++next) {
            const std::uint32_t i = todo[next];
            for (std::uint32_t side = 0; side < partial[i].sides && hides; ++side) {
                const std::uint32_t other = partners[first_side[i] + side];
                if (how == Connected::on && other != none) continue;
                const SideSaid here = ask(i, side);
                hides = here.satisfied || other != none;
                // A maximal set fails by one plane, whatever the others say.
                holds = !hides && how == Connected::on ? here.slack : std::min(holds, here.slack);
                if (!here.satisfied && other != none) add(other);
            }
        }
        if (hides) {
            slack = holds;
            std::sort(todo.begin(), todo.end());
            return todo;
        }
        slack = std::min(slack, holds);
    }
    return {};
}

}  // namespace sightline
