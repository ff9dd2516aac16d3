// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/transmittance_methods.h"

#include <algorithm>

#include "core/methods/cells/cell_method.h"
#include "core/methods/transmittance/tri.h"

namespace sightline {

namespace {

/// What all views of a problem share.
template <int D>
void prepare_light(const Problem<D>& problem, LightTransport usual) {
    cell_light(problem);
    if (takes_corners(problem, usual)) corner_rays(problem);
}

/// As the run lets it wait. Cost: the cell, and what the method makes for a view.
template <int D>
std::optional<double> waiting_key(const Problem<D>& problem, std::uint32_t cell, double key, std::uint32_t primitive) {
    const Tri<D> tri(problem);
    tri.add_waiting(problem, CellContents<D>(problem), cell, key);
    const auto held = problem.cells->primitives_of(cell);
    const auto found = std::find(held.begin(), held.end(), primitive);
    if (found == held.end()) return std::nullopt;
    return tri.waiting.key_of(problem.cells->cell_primitive_begin[cell] +
                              static_cast<std::uint32_t>(found - held.begin()));
}

}  // namespace

template <int D>
std::vector<Method<D>> transmittance_methods() {
    std::vector<Method<D>> table;
    table.push_back(cell_method<D, Flux<D>>("flux", "light", "cells by how much light from the eye reaches them"));
    table.back().parameters = {&transport_row(), &culled_cost_row(), &budget_counts_row(),
                               &neighbours_before_break_row()};
    table.back().prepare = [](const Problem<D>& problem) { prepare_light(problem, LightTransport::facets); };
    table.push_back(cell_method<D, Tri<D>>("tri", "light and size",
                                           "primitives by the light that reaches them and by how large they look"));
    table.back().parameters = {&maximise_row(), &transport_row()};
    table.back().prepare = [](const Problem<D>& problem) { prepare_light(problem, Tri<D>::usual_transport); };
    table.back().waiting_key = waiting_key<D>;
    table.push_back(
        cell_method<D, TriSeen<D>>("tri-seen", "light, size and last frame",
                                   "as tri, starting from the cells that showed something in the frame before, too"));
    table.back().parameters = {&maximise_row(), &transport_row()};
    table.back().prepare = table[1].prepare;
    table.back().waiting_key = waiting_key<D>;
    table.back().needs.image = table.back().needs.history = true;
    table.back().prefixes = false;  // what a frame leaves depends on its budget, and so does the order of the next
    table.back().compared = false;
    return table;
}

template std::vector<Method<2>> transmittance_methods<2>();
template std::vector<Method<3>> transmittance_methods<3>();

}  // namespace sightline
