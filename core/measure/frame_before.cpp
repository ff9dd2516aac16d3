// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/frame_before.h"

namespace sightline {

template <int D>
std::shared_ptr<const FrameHistory> frame_history(const Method<D>& method, Problem<D> problem,
                                                  const std::optional<View<D>>& before) {
    if (!method.needs.history || !before) return nullptr;
    problem.view = *before;
    if (method.prefixes) problem.budget = none;
    const std::unique_ptr<Run<D>> run = method.start(problem);
    run->run(none);
    return run->next_history();
}

template std::shared_ptr<const FrameHistory> frame_history<2>(const Method<2>&, Problem<2>,
                                                              const std::optional<View<2>>&);
template std::shared_ptr<const FrameHistory> frame_history<3>(const Method<3>&, Problem<3>,
                                                              const std::optional<View<3>>&);

}  // namespace sightline
