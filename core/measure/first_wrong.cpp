// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/first_wrong.h"

#include <algorithm>

#include "core/measure/metrics.h"

namespace sightline {

std::optional<FirstWrong> first_wrong(const Reference& reference, std::span<const Met> met, const Recording& recording,
                                      std::uint32_t budget) {
    const auto stays_missing = [](std::size_t missing, std::uint32_t left) {
        return missing > left ? missing - left : 0;
    };
    const std::size_t unavoidable = stays_missing(reference.count, budget);
    std::size_t missing = reference.count;
    for (std::uint32_t step = 1; step <= recording.size(); ++step) {
        missing -= visible_rendered(reference, recording.met_in(step, met));
        const std::uint32_t left = budget - std::min(budget, recording.after(step).spent);
        if (stays_missing(missing, left) > unavoidable)
            return FirstWrong{step, static_cast<std::uint32_t>(missing), left};
    }
    return std::nullopt;
}

}  // namespace sightline
