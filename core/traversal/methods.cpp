// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/traversal/methods.h"

#include <array>

#include "core/base/error.h"
#include "core/traversal/heuristics/layers.h"
#include "core/traversal/heuristics/published.h"
#include "core/traversal/orders.h"

namespace sightline {

template <int D>
std::span<const Method<D>> method_table() {
    // Draw-all methods render every visible primitive once the budget allows them all: conservative.
    static const std::array table{
        cell_method<D, PublishedSolidity>("published", "PLP",
                                          "Prioritized-Layered Projection with accumulated solidity (TVCG 2000)"),
        cell_method<D, LayerNumber>("layers", "layers", "cells by their distance from the seed in facets (the gem)"),
        primitive_method<D, CentroidOrder>("centroid", "centroid order",
                                           "primitives by the distance of their centroid (TVCG 4.5)",
                                           Guarantee::approximate),
        primitive_method<D, SceneOrderInView>(
            "view", "view culling", "primitives in the view, in the order of the scene", Guarantee::conservative),
        primitive_method<D, SceneOrder>("everything", "everything", "all primitives, in the order of the scene",
                                        Guarantee::conservative),
    };
    return table;
}

template <int D>
const Method<D>& find_method(std::span<const Method<D>> table, std::string_view id) {
    std::string known;
    for (const Method<D>& method : table) {
        if (method.id == id) return method;
        known += (known.empty() ? "" : ", ") + std::string(method.id);
    }
    throw InputError("method '" + std::string(id) + "' does not exist; there are " + known);
}

template std::span<const Method<2>> method_table<2>();
template std::span<const Method<3>> method_table<3>();
template const Method<2>& find_method<2>(std::span<const Method<2>>, std::string_view);
template const Method<3>& find_method<3>(std::span<const Method<3>>, std::string_view);

}  // namespace sightline
