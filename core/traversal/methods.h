// The method table: a row per way to order cells or primitives. Adding one is a file with a policy and a row.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/traversal/traverse.h"

namespace sightline {

enum class Guarantee : std::uint8_t { approximate, conservative };

template <int D>
struct Method {
    std::string_view id;
    std::string_view title;
    std::string_view sentence;  ///< one sentence for the help
    Guarantee guarantee = Guarantee::approximate;
    bool orders_cells = true;

    void (*start)(const Frame<D>&, State<D>&);
    /// Runs until something stops it, at most `steps` steps, without an observer.
    Stop (*run)(const Frame<D>&, State<D>&, std::uint32_t steps);
    /// One step with a recording.
    Stop (*record)(const Frame<D>&, State<D>&, Timeline&);
    /// The terms of the key of the cell behind `half`, a facet of `a`; nullptr for orders of primitives.
    Terms (*terms)(const Frame<D>&, std::uint32_t a, double rho_a, const HalfFacet& half);
    bool updates_enqueued = false;  ///< a cell in the front that is reached again may get a new key
};

/// Runs `step(frame, state, sink)` until it stops or `steps` steps were made.
template <int D, typename Step>
Stop run_steps(const Frame<D>& frame, State<D>& state, std::uint32_t steps, Step step) {
    NoSink sink;
    const std::uint64_t end = static_cast<std::uint64_t>(state.step) + steps;
    while (state.step < end)
        if (const Stop stop = step(frame, state, sink); stop != Stop::none) return stop;
    return Stop::steps;
}

/// The row of a heuristic that orders cells. A heuristic has seed_key, updates_enqueued and terms<D>
/// (heuristics/published.h is the model).
template <int D, typename Heuristic>
Method<D> cell_method(std::string_view id, std::string_view title, std::string_view sentence) {
    return {id,
            title,
            sentence,
            Guarantee::approximate,
            true,
            start_cells<D, Heuristic>,
            [](const Frame<D>& frame, State<D>& state, std::uint32_t steps) {
                return run_steps(frame, state, steps, step_cells<D, Heuristic, NoSink>);
            },
            [](const Frame<D>& frame, State<D>& state, Timeline& timeline) {
                Recorder recorder{timeline};
                return step_cells<D, Heuristic>(frame, state, recorder);
            },
            Heuristic::template terms<D>,
            Heuristic::updates_enqueued};
}

/// The row of an order of primitives (orders.h).
template <int D, typename Order>
Method<D> primitive_method(std::string_view id, std::string_view title, std::string_view sentence,
                           Guarantee guarantee) {
    return {id,
            title,
            sentence,
            guarantee,
            false,
            start_primitives<D, Order>,
            [](const Frame<D>& frame, State<D>& state, std::uint32_t steps) {
                return run_steps(frame, state, steps, step_primitives<D, Order, NoSink>);
            },
            [](const Frame<D>& frame, State<D>& state, Timeline& timeline) {
                Recorder recorder{timeline};
                return step_primitives<D, Order>(frame, state, recorder);
            },
            nullptr};
}

/// Every method that the programs know, in the order in which help shows them.
template <int D>
std::span<const Method<D>> method_table();

/// The row of that id in a table; throws InputError that lists the ids.
template <int D>
const Method<D>& find_method(std::span<const Method<D>> table, std::string_view id);

}  // namespace sightline
