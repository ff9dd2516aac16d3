// Whether occluders that meet at edges hide a box together (CT section 2.1, figures 3b, 4b, 4c and 5).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    std::uint32_t end = begin;
    while (end < halves_.size() && halves_[end].edge == halves_[begin].edge) ++end;
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

/// One that may hide a part of the box.
struct Partial {
    std::uint32_t shadow = 0;
    std::uint32_t sides = 0;
    bool beyond = false;
    std::uint64_t satisfied = 0;  ///< as Relation has it
};

/// Working memory.
struct JointScratch {
    std::vector<std::uint32_t> place;  ///< of a shadow among the partial ones
    std::vector<std::uint32_t> group, todo;
};

/// Some set of them that hides the box, as indices into `partial`, ascending; empty: none does. Only those count beyond
/// whose planes all of the box lies: they alone hide what they cover. on: maximal sets (TestOcclusion as printed, but
/// of the occluders that hide a part of the box only, since others add silhouette edges that spoil a set); grow: from
/// one to those on the other side of edges whose planes are not satisfied.
///
/// Why it is safe: each edge is satisfied, or crossed by two of them in opposite directions. So seen from the eye the
/// border of the set runs round each point of the box counter-clockwise, and it is covered at least once (a closed
/// surface round the eye covers all), by an occluder that the box lies beyond.
std::vector<std::uint32_t> joint_set(std::span<const Partial> partial, const Meetings& meetings, Connected how,
                                     JointScratch& scratch);

}  // namespace sightline
