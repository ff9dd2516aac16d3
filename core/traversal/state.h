// What a traversal reads (Frame) and what it changes (State): plain data that steps forward and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/view.h"
#include "core/settings/settings.h"
#include "core/space/cell_complex.h"
#include "core/traversal/front.h"

namespace sightline {

enum class CellState : std::uint8_t { clean, enqueued, projected, unseen };
inline constexpr auto cell_state_words = std::to_array<std::string_view>({"clean", "enqueued", "projected", "unseen"});

/// Everything a traversal needs and never changes. The pointers outlive the frame.
template <int D>
struct Frame {
    const std::vector<Primitive<D>>* primitives = nullptr;
    const CellComplex<D>* cells = nullptr;
    View<D> view;
    Settings settings;
    std::uint32_t budget = none;                ///< primitives; none: no limit
    double solidity_scale = 1;                  ///< what |A| is divided by: ρ_max or ρ95, never 0
    double solidity_limit = 0;                  ///< |A| / scale is cut here (1 for p95)
    Vec<D> forward{};                           ///< unit vector
    std::span<const std::uint8_t> two_sided{};  ///< as Scene::two_sided
};

/// Derives scale, limit, direction and budget from the settings.
template <int D>
Frame<D> make_frame(const std::vector<Primitive<D>>& primitives, const CellComplex<D>& cells, const View<D>& view,
                    const Settings& settings, std::span<const std::uint8_t> two_sided = {});

/// Whether the view can show the primitive: it meets the cone and, in 3D, turns a side to the eye that is seen.
inline bool shows(const Frame<2>& frame, std::uint32_t primitive) {
    return in_view(frame.view, (*frame.primitives)[primitive]);
}
inline bool shows(const Frame<3>& frame, std::uint32_t primitive) {
    const Primitive<3>& triangle = (*frame.primitives)[primitive];
    const bool both = !frame.two_sided.empty() && frame.two_sided[primitive];
    return (both || faces(frame.view, triangle)) && in_view(frame.view, triangle);
}

/// Why a run or a step ended.
enum class Stop : std::uint8_t { none, front_empty, budget, breakpoint, steps };
inline constexpr auto stop_words =
    std::to_array<std::string_view>({"none", "front empty", "budget", "breakpoint", "steps"});

/// Key, stamp and state of one cell. Clean cells have key 0 and stamp 0.
struct CellMark {
    double key = 0;
    std::uint32_t stamp = 0;
    CellState state = CellState::clean;
    bool operator==(const CellMark&) const = default;
};

/// The counters of a state: what a step changes besides marks and primitives.
struct Counters {
    std::uint32_t front_size = 0;       ///< cells in the front
    std::uint32_t next_stamp = 0;       ///< what the next cell put into the front gets
    std::uint32_t touched_count = 0;    ///< primitives met
    std::uint32_t rendered_count = 0;   ///< of those the ones not culled
    std::uint32_t spent = 0;            ///< against the budget
    std::uint32_t partial_cell = none;  ///< cell that the budget left partly rendered, or its neighbours pending
    std::uint32_t offset = 0;           ///< where to go on in it; for orders of primitives, in the order
};

template <int D>
struct State : Counters {
    /// A mark in 16 bytes. Marks of another frame count as clean: starting a frame costs nothing however large the
    /// scene is.
    struct PackedMark {
        double key = 0;
        std::uint32_t stamp = 0;
        std::uint32_t frame_and_state = 0;  ///< frame * 4 + state
    };
    static constexpr std::uint32_t last_frame = 0x3fffffffu;
    std::uint32_t frame = 0;  ///< number of the current frame, from 1 to last_frame
    std::vector<PackedMark> marks;
    Front front;
    bool front_is_stale = false;  ///< marks were put back by an undo: rebuild the front before using it

    /// Primitives in the order they were met in projected cells, each once. The first `touched_count` count; those
    /// behind are kept for redo. `culled_bit` marks the ones outside the view, which are not rendered.
    static constexpr std::uint32_t culled_bit = 0x80000000u;
    std::vector<std::uint32_t> touched;
    std::vector<std::uint32_t> primitive_frame;  ///< frame in which a primitive was last met

    std::uint32_t step = 0;            ///< steps taken
    std::vector<std::uint32_t> order;  ///< methods that order primitives, not cells: the whole order
    std::uint32_t seed = none;         ///< the seed cell (the first of several)

    CellMark mark(std::uint32_t cell) const {
        const PackedMark& m = marks[cell];
        if (m.frame_and_state >> 2 != frame) return {};
        return {m.key, m.stamp, static_cast<CellState>(m.frame_and_state & 3)};
    }
    void set_mark(std::uint32_t cell, const CellMark& mark) {
        marks[cell] = {mark.key, mark.stamp, frame << 2 | static_cast<std::uint32_t>(mark.state)};
    }
};

/// Makes the state clean for the next frame over these cells and primitives.
template <int D>
void begin_frame(State<D>& state, const Frame<D>& frame);

/// Puts a cell into the front with the next stamp.
template <int D>
void enqueue(State<D>& state, std::uint32_t cell, double key) {
    const CellMark old = state.mark(cell);
    state.front_size += old.state != CellState::enqueued;
    state.set_mark(cell, {key, state.next_stamp, CellState::enqueued});
    state.front.push({key, state.next_stamp, cell});
    ++state.next_stamp;
}

/// The first entry of the front, or nullptr when it is empty. Rebuilds the front from the marks after an undo.
template <int D>
const Front::Entry* front_top(State<D>& state);

/// 64-bit hash of per-cell state, key and stamp, the primitives met in order, the counters and the offset in a partly
/// rendered cell. No heap layout, no time.
template <int D>
std::uint64_t state_hash(const State<D>& state);

/// The cells to start from (TVCG 4.2 findCell): the one that holds the eye, else the nearest of those in view, else the
/// nearest. With seeds = hull and the eye outside: every border cell in view with a facet towards the eye, nearest
/// first. Empty when there are no cells.
template <int D>
std::vector<std::uint32_t> seed_cells(const Frame<D>& frame);

/// Whether the cell meets the view cone.
bool cell_in_view(const CellComplex<2>& cells, const View<2>& view, std::uint32_t cell);
bool cell_in_view(const CellComplex<3>& cells, const View<3>& view, std::uint32_t cell);

}  // namespace sightline
