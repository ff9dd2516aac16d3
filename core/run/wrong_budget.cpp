// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/wrong_budget.h"

#include <algorithm>
#include <limits>

#include "core/base/index.h"

namespace sightline {

void note_needed(NeededBudgets& frames, std::uint32_t budget, std::uint32_t needed) {
    constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max() / 2;
    if (needed == none) needed = 2 * std::clamp(budget, 1u, most);
    frames.last[frames.count++ % frames.last.size()] = needed;
}

std::uint32_t predict_needed(const NeededBudgets& frames, std::uint32_t total) {
    const std::size_t n = std::min(frames.count, frames.last.size());
    if (n == 0) return total;
    return std::min(total,
                    *std::max_element(frames.last.begin(), frames.last.begin() + static_cast<std::ptrdiff_t>(n)));
}

}  // namespace sightline
