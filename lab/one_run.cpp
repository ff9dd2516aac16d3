// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/one_run.h"

#include <cmath>

#include "core/run/drawn_levels.h"
#include "core/run/drive.h"

namespace sightline::lab {

template <int D>
MethodProblem<D> problem_of(std::span<const Method<D>> methods, const Scene<D>& scene, const CellComplex<D>& cells,
                            const View<D>& view, const Settings& settings, const Services& services) {
    const Variant<D> variant = make_variant<D>(methods, settings.method, settings.parameters);
    return {variant.method, make_problem(variant.method, variant.parameters, scene, cells, view,
                                         settings.budget.primitives(scene.primitives.size()), services)};
}

template <int D>
OneRun one_run(std::span<const Method<D>> methods, const Scene<D>& scene, const CellComplex<D>& cells,
               const View<D>& view, const Settings& settings, const Services& services) {
    const auto [method, problem] = problem_of(methods, scene, cells, view, settings, services);
    const std::unique_ptr<Run<D>> made = method.start(problem);
    drive(settings.budget, *made);
    OneRun run;
    run.order = rendered_ids(made->met());
    run.rendered = found_mask(*made);
    run.steps = made->steps();
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        run.not_finite += !std::isfinite(made->mark(cell).key);
    return run;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                                   \
    template MethodProblem<D> problem_of<D>(std::span<const Method<D>>, const Scene<D>&, const CellComplex<D>&,    \
                                            const View<D>&, const Settings&, const Services&);                     \
    template OneRun one_run<D>(std::span<const Method<D>>, const Scene<D>&, const CellComplex<D>&, const View<D>&, \
                               const Settings&, const Services&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
