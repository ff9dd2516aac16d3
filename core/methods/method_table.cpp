// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method_table.h"

#include <algorithm>

#include "core/methods/by_viewpoint/by_viewpoint.h"
#include "core/methods/cells/cell_method.h"
#include "core/methods/coorg_teller/coorg_teller.h"
#include "core/methods/cplp/cplp.h"
#include "core/methods/extinction/extinction.h"
#include "core/methods/feedback/feedback_run.h"
#include "core/methods/formula/formula_heuristic.h"
#include "core/methods/image_space/image_methods.h"
#include "core/methods/layers/layers.h"
#include "core/methods/levels/levels_method.h"
#include "core/methods/listed/listed.h"
#include "core/methods/orders/orders.h"
#include "core/methods/plp/published.h"
#include "core/methods/portals/portals.h"
#include "core/methods/transmittance/transmittance_methods.h"

namespace sightline {

namespace {

template <int D>
std::vector<Method<D>> rows() {
    std::vector<Method<D>> table;
    table.push_back(cell_method<D, PublishedSolidity<D>>(
        "published", "PLP", "Prioritized-Layered Projection with accumulated solidity (TVCG 2000)",
        plp_parameter_rows()));
    table.push_back(
        cell_method<D, LayerNumber>("layers", "layers", "cells by the number of facets from the seed (the gem)"));
    table.push_back(order_method<D>("centroid", "centroid order",
                                    "primitives by the distance of their centroid (TVCG 4.5)", centroid_order<D>()));
    table.back().aliases = {"distance"};
    table.push_back(view_method<D>());
    table.push_back(order_method<D>("everything", "everything", "all primitives, in scene order", scene_order<D>()));
    table.back().budgeted = false;
    table.push_back(cell_method<D, FormulaHeuristic<D>>(
        "formula", "formula", "cells by a key that you type: formula key=content+hops", formula_parameter_rows()));
    table.back().compared = false;
    table.push_back(order_method<D>("perfect", "perfect order",
                                    "only the visible primitives, nearest first: no method can do better",
                                    perfect_order<D>()));
    table.back().needs.visible_set = true;
    table.back().budgeted = false;
    table.back().compared = false;
    const std::vector<Method<D>> by_light = transmittance_methods<D>();
    std::vector<Method<D>> firsts;
    for (const Method<D>& method : table)
        if (method.orders_cells()) firsts.push_back(method);
    firsts.push_back(by_light.front());  // not one whose primitives wait: rounds render cells
    table.push_back(cplp_method<D>(std::move(firsts), cell_parameter_rows(plp_parameter_rows())));
    table.back().compared = false;
    for (Method<D>& method : image_methods<D>(table.front())) table.push_back(std::move(method));
    for (Method<D>& method : object_space_methods<D>()) table.push_back(std::move(method));
    table.push_back(cell_method<D, Extinction<D>>(
        "extinction", "extinction", "cells by the optical depth between them and the eye (what the gem wishes for)"));
    table.back().prepare = [](const Problem<D>& problem) { cell_extinction(problem); };
    table.insert(table.end(), by_light.begin(), by_light.end());
    table.push_back(feedback_method<D>());
    table.push_back(levels_method<D>());
    for (Method<D>& method : portal_methods<D>()) table.push_back(std::move(method));
    table.push_back(viewpoint_method<D>(table));
    table.push_back(listed_method<D>());  // last: colours follow the order
    return table;
}

}  // namespace

template <>
std::span<const Method<2>> method_table<2>() {
    static const std::vector<Method<2>> table = rows<2>();
    return table;
}

template <>
std::span<const Method<3>> method_table<3>() {
    static const std::vector<Method<3>> table = rows<3>();
    return table;
}

std::span<const ParameterRow* const> all_parameters() {
    static const std::vector<const ParameterRow*> all = [] {
        std::vector<const ParameterRow*> found;
        const auto add = [&](const auto& table) {
            for (const auto& method : table)
                for (const ParameterRow* row : method.parameters)
                    if (std::none_of(found.begin(), found.end(),
                                     [&](const ParameterRow* other) { return other->name == row->name; }))
                        found.push_back(row);
        };
        add(method_table<2>());
        add(method_table<3>());
        return found;
    }();
    return all;
}

}  // namespace sightline
