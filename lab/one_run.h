// One run of one method in one view, without a recording: what it rendered.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/run/method.h"
#include "core/session/settings.h"

namespace sightline::lab {

struct OneRun {
    std::vector<std::uint32_t> order;    ///< rendered primitives
    std::vector<std::uint8_t> rendered;  ///< per primitive, 1 or 0
    std::uint32_t steps = 0;
    std::uint32_t not_finite = 0;  ///< cells whose key is NaN or infinite
};

/// The settings' method, or variant, and what a run of it is given.
template <int D>
struct MethodProblem {
    Method<D> method;
    Problem<D> problem;
};
template <int D>
MethodProblem<D> problem_of(std::span<const Method<D>> methods, const Scene<D>& scene, const CellComplex<D>& cells,
                            const View<D>& view, const Settings& settings, const Services& services);

/// To the budget of the settings.
template <int D>
OneRun one_run(std::span<const Method<D>> methods, const Scene<D>& scene, const CellComplex<D>& cells,
               const View<D>& view, const Settings& settings, const Services& services);

}  // namespace sightline::lab
