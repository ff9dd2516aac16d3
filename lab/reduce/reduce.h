// Shrinking a scene in which something goes wrong to the fewest primitives in which it still does.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lab/measure/lab_scene.h"
#include "lab/measure/measure_path.h"

namespace sightline::lab {

/// Whether what is looked for holds in a scene of these primitives (ascending indices).
using Holds = std::function<bool(std::span<const std::uint32_t> kept)>;

/// Where a reduction stands after a probe.
struct ReduceProgress {
    std::size_t left = 0;    ///< primitives of the smallest set in which it holds
    std::size_t probes = 0;  ///< so far
    std::size_t most = 0;    ///< probes more at most, unless one of them makes it smaller again
};
/// Told after each probe; false stops there.
using ReduceWatch = std::function<bool(const ReduceProgress&)>;

/// Delta debugging (Zeller and Hildebrandt 2002): a subset of 0 … count - 1 in which it holds and, unless it was
/// stopped, from which no single one can be taken. Throws InputError when it does not hold in the whole.
std::vector<std::uint32_t> reduce(std::uint32_t count, const Holds& holds, const ReduceWatch& watch = {});

/// The scene without the others.
template <int D>
Scene<D> subset(const Scene<D>& scene, std::span<const std::uint32_t> kept);

/// What to look for.
struct Wanted {
    std::string condition;  ///< over a step's record, as --until takes it; holds when it does after any step
    std::string measures;   ///< over the measures of the last view, such as "pop > 0.2 && coverage < 0.5"
};

/// Tessellates the subset and runs the method of `lab.settings` in the last of lab.views; measures see the view before
/// it too, where there is one. Exactly one of both texts is not empty. `lab` outlives it. Throws InputError for a text
/// that is no formula.
template <int D>
Holds holds_in(const LabScene<D>& lab, const MethodChoice& method, const Budget& budget, const Wanted& wanted,
               const DrawIds& draw_ids);

}  // namespace sightline::lab
