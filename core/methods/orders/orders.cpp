// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/orders/orders.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"

namespace sightline {

namespace {

template <int D>
std::vector<std::uint32_t> in_scene_order(const Problem<D>& problem) {
    std::vector<std::uint32_t> order(problem.primitives().size());
    std::iota(order.begin(), order.end(), 0u);
    return order;
}

/// The visible ones, as NearestFirst orders all.
template <int D>
std::vector<std::uint32_t> visible_by_centroid(const Problem<D>& problem) {
    const auto visible = problem.services.visible_set ? problem.services.visible_set() : nullptr;
    if (!visible) throw WorkError("method 'perfect' needs the exact visible set, which is not available here");
    std::vector<std::pair<double, std::uint32_t>> keys;
    std::uint32_t id = 0;
    for (const Primitive<D>& p : problem.primitives()) {
        const std::uint32_t primitive = id++;
        if (!(*visible)[primitive]) continue;
        const Vec<D> d = centroid<D>(p) - problem.view.eye;
        keys.emplace_back(glm::dot(d, d), primitive);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const auto& key : keys) order.push_back(key.second);
    return order;
}

}  // namespace

template <int D>
PrimitiveOrder<D> scene_order() {
    return {in_scene_order<D>, false, Misses::none, "take the primitives in scene order", {}};
}

template <int D>
PrimitiveOrder<D> centroid_order() {
    return {{}, true, Misses::may, "order the primitives, nearest centroid first", "TVCG section 4.5"};
}

template <int D>
PrimitiveOrder<D> perfect_order() {
    return {visible_by_centroid<D>,
            false,
            D == 2 ? Misses::none : Misses::none_at_this_resolution,
            "order the visible primitives, nearest centroid first",
            {},
            1};
}

#define SIGHTLINE_INSTANTIATE(D)                    \
    template PrimitiveOrder<D> scene_order<D>();    \
    template PrimitiveOrder<D> centroid_order<D>(); \
    template PrimitiveOrder<D> perfect_order<D>();
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
