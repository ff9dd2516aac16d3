// Whether occluders that meet at edges hide a box together (CT section 2.1, figures 3b, 4b, 4c and 5).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/coorg_teller/object_space_parameters.h"
#include "core/methods/coorg_teller/shadow.h"

namespace sightline {

/// For each side of each shadow, the shadow that shares its edge from the opposite side as the eye sees it; none: the
/// side is a silhouette whoever is asked. An edge of more than two polygons joins the first two that fit.
class Meetings {
public:
    template <int D>
    void find(std::span<const Shadow<D>> shadows);
    std::uint32_t partner(std::uint32_t shadow, std::uint32_t side) const { return partner_[begin_[shadow] + side]; }

private:
    std::vector<std::uint32_t> begin_, partner_;
    struct Half {
        std::uint32_t edge, shadow, side;
        bool reversed;
    };
    std::vector<Half> halves_;
};

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
