// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/coorg_teller/coorg_teller.h"

#include "core/methods/coorg_teller/visible_run.h"

namespace sightline {

namespace {

template <int D>
Method<D> object_space_method(std::string_view id, std::string_view title, std::string_view sentence,
                              OccluderKind kind) {
    Method<D> row{id, title, sentence, [kind](const Problem<D>& problem) -> std::unique_ptr<Run<D>> {
                      return std::make_unique<VisibleRun<D>>(problem, kind);
                  }};
    row.pops = Kind::node;
    row.prepare = [](const Problem<D>& problem) { prepared(problem); };
    row.needs.cells = false;
    row.needs.last_frame = true;
    row.budgeted = false;
    row.promise = Misses::none;
    row.parameters = {kind == OccluderKind::polygon ? &occluder_count_row() : &shadow_count_row(),
                      &threshold_row(),
                      &tree_row(),
                      &leaf_row(),
                      &leaves_row(),
                      &coherence_row(),
                      &step_is_row(),
                      &workers_row()};
    if (kind == OccluderKind::polygon) row.parameters.insert(row.parameters.begin(), &connected_row());
    return row;
}

}  // namespace

template <int D>
std::vector<Method<D>> object_space_methods() {
    return {object_space_method<D>("coorg-teller", "Coorg-Teller",
                                   "boxes in the shadows of a few large polygons are dropped, plane by plane "
                                   "(Coorg and Teller 1996)",
                                   OccluderKind::polygon),
            object_space_method<D>("shadow-frusta", "shadow frusta",
                                   "boxes in the shadows of a few large convex occluders are dropped (Hudson 1997)",
                                   OccluderKind::convex)};
}

template std::vector<Method<2>> object_space_methods<2>();
template std::vector<Method<3>> object_space_methods<3>();

}  // namespace sightline
