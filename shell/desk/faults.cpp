// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/desk/faults.h"

#include "core/base/error.h"
#include "core/session/headline.h"
#include "shell/desk/moves.h"

namespace sightline {

template <int D>
const Faults* faults(const Workbench<D>& bench) {
    const bool of_this =
        bench.faults && bench.faults->run == bench.run && bench.faults->size == bench.session.settings().reference_size;
    return of_this && tells_truth(bench.session) ? &*bench.faults : nullptr;
}

template <int D>
bool update_faults(Workbench<D>& bench, bool with_objects) {
    if (bench.session.flying() || !tells_truth(bench.session)) return false;
    const Faults* const known = faults(bench);
    if (known && (known->objects || !with_objects)) return false;
    const Session<D> end = at_the_end(bench.session);
    if (!known) bench.faults = {bench.run, end.settings().reference_size, missed_by(end), {}};
    if (!with_objects) return true;
    bench.faults->objects = object_reports(end);
    sort_by_fault(*bench.faults->objects);
    return true;
}

template <int D>
void hunt(Workbench<D>& bench, std::uint32_t region) {
    update_faults(bench);
    const Faults* const found = faults(bench);
    if (!found) throw InputError("what is visible is hidden, or the eye is flying: what is missed is not told");
    const std::vector<WrongRegion>& regions = found->missed.regions;
    if (region < 1 || region > regions.size())
        throw InputError(regions.empty() ? std::string("nothing is missed: no pixel is wrong at the end of this run")
                                         : "there is no wrong region " + std::to_string(region) + "; there are " +
                                               std::to_string(regions.size()) + ", from 1");
    const std::uint32_t primitive = regions[region - 1].primitives.front().primitive;
    run_to_end(bench);
    Session<D>& session = bench.session;
    session.selected_cell = session.selected_node = session.selected_plane = none;
    session.selected_primitive = primitive;
    bench.pixel.reset();
    bench.desk.right = "why";
}

#define SIGHTLINE_INSTANTIATE(D)                           \
    template const Faults* faults<D>(const Workbench<D>&); \
    template bool update_faults<D>(Workbench<D>&, bool);   \
    template void hunt<D>(Workbench<D>&, std::uint32_t);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
