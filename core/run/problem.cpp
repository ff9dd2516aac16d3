// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/problem.h"

#include "core/base/hash.h"

namespace sightline {

std::uint64_t FrameHistory::hash() const {
    Hash hash;
    for (const std::uint8_t seen : visible) hash.add(seen);
    for (const std::uint8_t state : boxes) hash.add(state);
    for (const std::uint8_t shows : cells) hash.add(shows);
    for (const char c : technique) hash.add(static_cast<std::uint8_t>(c));
    return hash.value();
}

const ParameterRow& culled_cost_row() {
    static const ParameterRow row = choice_row("culled_cost", CulledCost::free, "docs/algorithm.md, budget",
                                               "a primitive outside the view costs nothing, or counts against the "
                                               "budget");
    return row;
}

}  // namespace sightline
