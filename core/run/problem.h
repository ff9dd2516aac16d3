// What a run is given and never changes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/image_size.h"
#include "core/run/drawn.h"
#include "core/run/parameters.h"
#include "core/run/step.h"
#include "core/scene/view.h"
#include "core/space/cell_complex.h"

namespace sightline {

/// What the frames before this one leave to it. It decides, so it is an input: immutable, hashed, and kept in state
/// files as the views of those frames.
struct FrameHistory {
    std::vector<std::uint8_t> visible;  ///< per primitive: seen in the last frame, as its method knows it
    std::vector<std::uint8_t> boxes{};  ///< per box of the method's tree: what became of it, as the method has it
    std::vector<std::uint8_t> cells{};  ///< per cell: it showed something
    std::string technique{};            ///< that was chosen, of a method that chooses one
    std::uint64_t hash() const;
};

/// What a method may ask for while it runs.
struct Services {
    /// The exact visible set, per primitive; empty: there is none to be had.
    std::function<std::shared_ptr<const std::vector<std::uint8_t>>()> visible_set;
    ImageSize image;  ///< of depth images that decide; as image_size<D> completes it
    int threads = 0;  ///< that draw such images, 0: as many as the machine has; decides nothing
};

/// The pointers outlive the run.
template <int D>
struct Problem {
    const Scene<D>* scene = nullptr;
    const CellComplex<D>* cells = nullptr;
    View<D> view;
    std::uint32_t budget = none;  ///< primitives; none: no limit
    Parameters parameters;        ///< of the method
    std::shared_ptr<const FrameHistory> history;
    Services services;

    const std::vector<Primitive<D>>& primitives() const { return scene->primitives; }
    /// Built when it is first asked for.
    const BoxTree<D>& boxes() const { return cells->boxes->of(*scene); }
};

inline bool turns_a_seen_side(const Problem<2>&, std::uint32_t) { return true; }
inline bool turns_a_seen_side(const Problem<3>& problem, std::uint32_t primitive) {
    return shows_both_sides(*problem.scene, primitive) || faces(problem.view, problem.scene->primitives[primitive]);
}

/// Whether the view can show the primitive: it meets the cone and, in 3D, turns a side to the eye that is seen.
template <int D>
bool shows(const Problem<D>& problem, std::uint32_t primitive) {
    return turns_a_seen_side(problem, primitive) && in_view(problem.view, problem.scene->primitives[primitive]);
}

enum class CulledCost : std::uint8_t { free, charged };
template <>
inline constexpr auto words<CulledCost> = std::to_array<std::string_view>({"free", "charged"});

/// Whether a primitive outside the view counts against the budget.
const ParameterRow& culled_cost_row();

/// Appends to what was met, where the budget has place for it; false: nothing changed.
inline bool add_met(std::uint32_t budget, bool culled_costs, Met met, Drawn& drawn, Counters& counters) {
    const bool costs = !met.culled() || culled_costs;
    if (costs && counters.spent >= budget) return false;
    drawn.add(counters.touched_count, met);
    ++counters.touched_count;
    counters.rendered_count += !met.culled();
    counters.spent += costs;
    return true;
}

/// Meets a primitive, once: renders it, or finds it outside the view when the method culls. False when the budget has
/// no place for it: nothing changed.
template <int D>
bool meet(const Problem<D>& problem, bool culled_costs, std::uint32_t primitive, bool culls, Drawn& drawn,
          Counters& counters) {
    if (drawn.has(primitive)) return true;
    const bool culled = culls && !shows(problem, primitive);
    return add_met(problem.budget, culled_costs, {primitive, culled}, drawn, counters);
}

/// Meets several that have not been met; the budget has place for them all.
inline void meet_all(std::span<const std::uint32_t> primitives, Drawn& drawn, Counters& counters) {
    const auto count = static_cast<std::uint32_t>(primitives.size());
    drawn.add_all(counters.touched_count, primitives);
    counters.touched_count += count;
    counters.rendered_count += count;
    counters.spent += count;
}

}  // namespace sightline
