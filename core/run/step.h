// What a run did, as plain data: items, marks, changes, steps. A recording is a list of them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/index.h"
#include "core/run/drawn.h"

namespace sightline {

/// What an item is.
enum class Kind : std::uint8_t {
    none,
    cell,
    facet,
    primitive,
    node,
    vertex,
    object,
    region,
    portal,
    tile,
    round,
};
inline constexpr auto kind_words = std::to_array<std::string_view>(
    {"none", "cell", "facet", "primitive", "node", "vertex", "object", "region", "portal", "tile", "round"});

constexpr std::string_view kind_word(Kind kind) { return kind_words[static_cast<std::size_t>(kind)]; }

/// Something that a method pops, changes or speaks of.
struct Item {
    std::uint32_t id = none;
    Kind kind = Kind::none;

    explicit operator bool() const { return kind != Kind::none; }
    bool operator==(const Item&) const = default;
};
/// "cell 12"
inline std::string item_name(const Item& item) {
    return std::string(kind_word(item.kind)) + " " + std::to_string(item.id);
}
inline Item cell_item(std::uint32_t cell) { return cell == none ? Item{} : Item{cell, Kind::cell}; }
inline Item facet_item(std::uint32_t facet) { return {facet, Kind::facet}; }
inline Item primitive_item(std::uint32_t primitive) { return {primitive, Kind::primitive}; }

/// The index of an item of that kind; none for any other.
inline std::uint32_t id_of(const Item& item, Kind kind) { return item.kind == kind ? item.id : none; }

/// A coarser level of detail in place of an object.
struct StandIn {
    std::uint32_t object = none;  ///< of all_objects(scene)
    std::uint8_t level = 0;       ///< 1 is the finest that is coarser than the object
    bool operator==(const StandIn&) const = default;
};

/// How far an item has come (the gem's NS_CLEAN, NS_ENQUEUED, NS_PROJECTED, NS_UNSEEN); unseen: outside the view;
/// hidden: popped and found hidden, which cells are only while they wait.
enum class CellState : std::uint8_t { clean, enqueued, projected, unseen, hidden };
inline constexpr auto cell_state_words =
    std::to_array<std::string_view>({"clean", "enqueued", "projected", "unseen", "hidden"});

/// Key, stamp and state of one item. Clean items have key 0 and stamp 0.
struct Mark {
    double key = 0;
    std::uint32_t stamp = 0;
    CellState state = CellState::clean;
    bool operator==(const Mark&) const = default;
};

/// The order of a front: lowest key first, among equal ones the older stamp.
inline bool comes_before(const Mark& a, const Mark& b) {
    return a.key < b.key || (a.key == b.key && a.stamp < b.stamp);
}

/// Why a run or a step ended.
enum class Stop : std::uint8_t { none, front_empty, budget, breakpoint, steps, complete };
inline constexpr auto stop_words = std::to_array<std::string_view>(
    {"none", "front empty", "budget", "breakpoint", "steps", "nothing visible is left"});

/// The counters of a run: what a step changes besides marks and primitives.
struct Counters {
    std::uint32_t front_size = 0;       ///< items in the front
    std::uint32_t next_stamp = 0;       ///< what the next item put into the front gets
    std::uint32_t touched_count = 0;    ///< primitives met
    std::uint32_t rendered_count = 0;   ///< of those the ones not culled
    std::uint32_t spent = 0;            ///< against the budget
    std::uint32_t partial_cell = none;  ///< item that the budget left partly rendered, or its neighbours pending
    std::uint32_t offset = 0;           ///< where to go on in it; for orders of primitives, in the order
    std::uint32_t refreshed = 0;        ///< primitives met when the depths that boxes are tested against were refreshed
    std::uint32_t stood_in = 0;         ///< primitives of levels, drawn in place of those of objects

    std::uint32_t drawn() const { return rendered_count + stood_in; }  ///< all that goes to the card
    bool operator==(const Counters&) const = default;
};

/// One thing that a step altered or deliberately kept. The mark is the item's on the other side of the recording's
/// position: the one before the step when the step is done, the one after it when it is undone.
struct Change {
    double key = 0;
    std::uint32_t stamp = 0;
    std::uint32_t id = none;   ///< of the item
    std::uint32_t via = none;  ///< cell methods: the facet; else what the method says
    std::uint8_t rule = 0;     ///< the method's; Run::rule_words
    bool penalty = false;      ///< the key that the step computed carries a penalty
    Kind kind = Kind::none;
    CellState state = CellState::clean;

    Item item() const { return {id, kind}; }
    Mark mark() const { return {key, stamp, state}; }
    void set_mark(const Mark& mark) {
        key = mark.key;
        stamp = mark.stamp;
        state = mark.state;
    }
};
static_assert(sizeof(Change) == 24);

/// One pop.
struct Step {
    Item item;       ///< popped; of kind none for a batch of primitives
    Item runner_up;  ///< next in the front when the item was popped; of kind none: it was alone
    double key = 0;  ///< of the item
    double runner_up_key = 0;
    std::uint32_t stamp = 0;  ///< of the item
    std::uint32_t first_change = 0;
    std::uint32_t first_note = 0;
    Counters after;
};

/// The steps of a run. Step numbers count from 1, as people do: step s is steps[s - 1]; 0 is the start.
struct Recording {
private:
    template <typename Rows>
    auto part(Rows& rows, std::uint32_t step, std::uint32_t Step::*first) const {
        const std::size_t begin = steps[step - 1].*first;
        const std::size_t end = step < steps.size() ? steps[step].*first : rows.size();
        return std::span(rows).subspan(begin, end - begin);
    }

public:
    std::vector<Step> steps;
    std::vector<Change> changes;
    std::vector<std::byte> notes;  ///< what methods add to a step, in their own form
    Counters start;                ///< before the first step

    std::uint32_t size() const { return static_cast<std::uint32_t>(steps.size()); }
    std::span<const Change> changes_of(std::uint32_t step) const { return part(changes, step, &Step::first_change); }
    std::span<Change> changes_of(std::uint32_t step) { return part(changes, step, &Step::first_change); }
    std::span<const std::byte> notes_of(std::uint32_t step) const { return part(notes, step, &Step::first_note); }
    /// The counters when `step` steps are done.
    const Counters& after(std::uint32_t step) const { return step > 0 ? steps[step - 1].after : start; }
    const Counters& before(std::uint32_t step) const { return after(step - 1); }
    /// Of what the run met, as far as the recording goes at least, the part that a step met.
    std::span<const Met> met_in(std::uint32_t step, std::span<const Met> met) const {
        const std::uint32_t first = before(step).touched_count;
        return met.subspan(first, after(step).touched_count - first);
    }
    /// Gives a step fewer changes.
    void shorten(std::uint32_t step, std::span<const Change> kept) {
        const std::size_t first = steps[step - 1].first_change, drop = changes_of(step).size() - kept.size();
        std::copy(kept.begin(), kept.end(), changes.begin() + static_cast<std::ptrdiff_t>(first));
        const auto end = changes.begin() + static_cast<std::ptrdiff_t>(first + kept.size());
        changes.erase(end, end + static_cast<std::ptrdiff_t>(drop));
        for (std::size_t later = step; later < steps.size(); ++later)
            steps[later].first_change -= static_cast<std::uint32_t>(drop);
    }
    std::size_t memory_bytes() const {
        return steps.capacity() * sizeof(Step) + changes.capacity() * sizeof(Change) + notes.capacity();
    }
};

}  // namespace sightline
