// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/transmittance/transmittance_methods.h"

#include "core/methods/cells/cell_method.h"
#include "core/methods/transmittance/tri.h"

namespace sightline {

template <int D>
std::vector<Method<D>> transmittance_methods() {
    std::vector<Method<D>> table;
    table.push_back(cell_method<D, Flux<D>>("flux", "light", "cells by how much light from the eye reaches them"));
    table.back().parameters = {&culled_cost_row(), &budget_counts_row(), &neighbours_before_break_row()};
    table.back().prepare = [](const Problem<D>& problem) { cell_light(problem); };
    table.push_back(cell_method<D, Tri<D>>("tri", "light and size",
                                           "primitives by the light that reaches them and by how large they look"));
    table.back().parameters = {&maximise_row()};
    table.back().prepare = table.front().prepare;
    table.push_back(
        cell_method<D, TriSeen<D>>("tri-seen", "light, size and last frame",
                                   "as tri, starting from the cells that showed something in the frame before, too"));
    table.back().parameters = {&maximise_row()};
    table.back().prepare = table.front().prepare;
    table.back().needs.image = table.back().needs.history = true;
    table.back().prefixes = false;  // what a frame leaves depends on its budget, and so does the order of the next
    table.back().compared = false;
    return table;
}

template std::vector<Method<2>> transmittance_methods<2>();
template std::vector<Method<3>> transmittance_methods<3>();

}  // namespace sightline
