// Methods without cells: whole orders of primitives, to compare with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>

#include "core/traversal/state.h"

namespace sightline {

template <int D>
std::vector<std::uint32_t> in_scene_order(const Frame<D>& frame) {
    std::vector<std::uint32_t> order(frame.primitives->size());
    std::iota(order.begin(), order.end(), 0u);
    return order;
}

/// Draws all, culls nothing.
struct SceneOrder {
    static constexpr bool culls = false;
    template <int D>
    static std::vector<std::uint32_t> primitives(const Frame<D>& frame) {
        return in_scene_order(frame);
    }
};

/// View culling only.
struct SceneOrderInView {
    static constexpr bool culls = true;
    template <int D>
    static std::vector<std::uint32_t> primitives(const Frame<D>& frame) {
        return in_scene_order(frame);
    }
};

/// Nearest centroid first (TVCG 4.5); equal distances by id.
struct CentroidOrder {
    static constexpr bool culls = true;
    template <int D>
    static std::vector<std::uint32_t> primitives(const Frame<D>& frame) {
        std::vector<std::pair<double, std::uint32_t>> keys;
        keys.reserve(frame.primitives->size());
        for (const Primitive<D>& p : *frame.primitives) {
            Vec<D> sum(0);
            for (const Vec<D>& v : p) sum += v;
            const Vec<D> d = sum / static_cast<double>(D) - frame.view.eye;
            keys.emplace_back(glm::dot(d, d), static_cast<std::uint32_t>(keys.size()));
        }
        std::sort(keys.begin(), keys.end());
        std::vector<std::uint32_t> order;
        order.reserve(keys.size());
        for (const auto& key : keys) order.push_back(key.second);
        return order;
    }
};

}  // namespace sightline
