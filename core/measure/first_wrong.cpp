// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/first_wrong.h"

#include <algorithm>

#include "core/measure/metrics.h"

namespace sightline {

template <int D>
std::optional<FirstWrong> first_wrong(const Reference& reference, std::span<const std::uint32_t> touched,
                                      const Timeline& timeline, std::uint32_t budget) {
    const auto stays_missing = [](std::size_t missing, std::uint32_t left) {
        return missing > left ? missing - left : 0;
    };
    const std::size_t unavoidable = stays_missing(reference.count, budget);
    std::size_t missing = reference.count;
    for (std::uint32_t step = 1; step <= timeline.steps.size(); ++step) {
        const StepRecord& record = timeline.steps[step - 1];
        const std::uint32_t first = timeline.touched_before(step);
        missing -= visible_rendered<D>(reference, touched.subspan(first, record.touched_count - first));
        const std::uint32_t left = budget - std::min(budget, record.spent);
        if (stays_missing(missing, left) > unavoidable)
            return FirstWrong{step, static_cast<std::uint32_t>(missing), left};
    }
    return std::nullopt;
}

template std::optional<FirstWrong> first_wrong<2>(const Reference&, std::span<const std::uint32_t>, const Timeline&,
                                                  std::uint32_t);
template std::optional<FirstWrong> first_wrong<3>(const Reference&, std::span<const std::uint32_t>, const Timeline&,
                                                  std::uint32_t);

}  // namespace sightline
