// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/joint_test.h"

#include <algorithm>

namespace sightline {

template <int D>
void Meetings::find(std::span<const Shadow<D>> shadows) {
    begin_.clear();
    halves_.clear();
    std::uint32_t count = 0;
    for (std::uint32_t shadow = 0; shadow < shadows.size(); ++shadow) {
        begin_.push_back(count);
        const auto& sides = shadows[shadow].sides;
        for (std::uint32_t side = 0; side < sides.size(); ++side, ++count)
            halves_.push_back({sides[side].edge, sides[side].polygon, shadow, side, sides[side].reversed});
    }
    group_.resize(count);
    std::sort(halves_.begin(), halves_.end(), [](const Half& a, const Half& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.polygon != b.polygon ? a.polygon < b.polygon : a.side < b.side;
    });
    for (std::uint32_t i = 0, first = 0; i < halves_.size(); ++i) {
        if (halves_[i].edge != halves_[first].edge) first = i;
        group_[begin_[halves_[i].shadow] + halves_[i].side] = first;
    }
}

template void Meetings::find<2>(std::span<const Shadow<2>>);
template void Meetings::find<3>(std::span<const Shadow<3>>);

}  // namespace sightline
