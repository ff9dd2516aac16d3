// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/one_run.h"

#include <cmath>

#include "core/traversal/methods.h"

namespace sightline::lab {

template <int D>
OneRun one_run(const Scene<D>& scene, const CellComplex<D>& cells, const View<D>& view, const Settings& settings) {
    const Method<D>& method = find_method<D>(method_table<D>(), settings.method);
    const Frame<D> frame = make_frame<D>(scene.primitives, cells, view, settings, scene.two_sided);
    State<D> state;
    method.start(frame, state);
    method.run(frame, state, none);
    OneRun run;
    run.rendered.resize(scene.primitives.size());
    for (std::uint32_t i = 0; i < state.touched_count; ++i) {
        if (state.touched[i] & State<D>::culled_bit) continue;
        run.order.push_back(state.touched[i]);
        run.rendered[state.touched[i]] = 1;
    }
    run.steps = state.step;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell)
        run.not_finite += !std::isfinite(state.mark(cell).key);
    return run;
}

#define SIGHTLINE_INSTANTIATE(D) \
    template OneRun one_run<D>(const Scene<D>&, const CellComplex<D>&, const View<D>&, const Settings&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline::lab
