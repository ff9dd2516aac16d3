// What a traversal did, step by step: enough to undo and redo it and to explain it. Terms are not stored; the
// heuristic computes them again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/traversal/state.h"

namespace sightline {

/// What happened to the neighbour across a facet of the cell just projected.
enum class Rule : std::uint8_t {
    border,         ///< there is no neighbour
    projected,      ///< projected before: left alone
    enqueued,       ///< was clean: now in the front
    reenqueued,     ///< was in the front: now there with the new key and a new stamp
    kept,           ///< was in the front and keeps its key (on_reenqueue = min or max, or a method without updates)
    marked_unseen,  ///< was clean and lies outside the view: now unseen
    unseen,         ///< found outside the view before: left alone
};
inline constexpr auto rule_words = std::to_array<std::string_view>(
    {"border", "projected before", "enqueued", "re-enqueued", "kept", "marked unseen", "unseen before"});

/// One per facet of the cell, in its order. The mark is the neighbour's on the other side of the timeline's position:
/// the one before the step when the step is done, the one after it when it is undone.
struct FacetRecord {
    double key = 0;
    std::uint32_t stamp = 0;
    CellState state = CellState::clean;
    Rule rule = Rule::border;
};
static_assert(sizeof(FacetRecord) <= 32);

/// One per step, with the counters after it.
struct StepRecord : Counters {
    std::uint32_t cell = none;  ///< popped; none for methods that order primitives
    std::uint32_t first_facet = 0;
    double runner_up_key = 0;
    std::uint32_t runner_up = none;  ///< next in the front when the cell was popped; none: it was alone
};

struct Timeline {
    std::vector<StepRecord> steps;
    std::vector<FacetRecord> facets;
    std::uint32_t seed_count = 0;  ///< cells in the front at step 0

    /// Step numbers count from 1, as people do: step s is steps[s - 1].
    std::span<const FacetRecord> facets_of(std::uint32_t step) const {
        const std::uint32_t begin = steps[step - 1].first_facet;
        const auto end = step < steps.size() ? steps[step].first_facet : static_cast<std::uint32_t>(facets.size());
        return std::span(facets).subspan(begin, end - begin);
    }
    std::uint32_t rendered_before(std::uint32_t step) const { return step > 1 ? steps[step - 2].rendered_count : 0; }
    std::uint32_t touched_before(std::uint32_t step) const { return step > 1 ? steps[step - 2].touched_count : 0; }
    std::size_t memory_bytes() const {
        return steps.capacity() * sizeof(StepRecord) + facets.capacity() * sizeof(FacetRecord);
    }
};

/// Undoes the last step of the state, which the timeline holds.
template <int D>
void undo_step(const Frame<D>& frame, State<D>& state, Timeline& timeline);

/// Does the step after the state's again, from its record. No key is computed and the front is not touched.
template <int D>
void redo_step(const Frame<D>& frame, State<D>& state, Timeline& timeline);

/// Sinks of the traversal (traverse.h): one that records, and one that is compiled away.
struct Recorder {
    static constexpr bool enabled = true;
    Timeline& timeline;

    void popped(std::uint32_t cell, const Front::Entry* runner_up) {
        StepRecord record;
        record.cell = cell;
        record.first_facet = static_cast<std::uint32_t>(timeline.facets.size());
        if (runner_up) {
            record.runner_up = runner_up->cell;
            record.runner_up_key = runner_up->key;
        }
        timeline.steps.push_back(record);
    }
    void facet(const CellMark& before, Rule rule) {
        timeline.facets.push_back({before.key, before.stamp, before.state, rule});
    }
    template <int D>
    void finished(const State<D>& state) {
        static_cast<Counters&>(timeline.steps.back()) = state;
    }
};

struct NoSink {
    static constexpr bool enabled = false;
};

}  // namespace sightline
