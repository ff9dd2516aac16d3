// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/traversal/state.h"

#include <algorithm>

namespace sightline {

template <int D>
Frame<D> make_frame(const std::vector<Primitive<D>>& primitives, const CellComplex<D>& cells, const View<D>& view,
                    const Settings& settings, std::span<const std::uint8_t> two_sided) {
    Frame<D> frame{&primitives, &cells, view, settings};
    frame.two_sided = two_sided;
    frame.budget = settings.budget.primitives(primitives.size());
    const bool p95 = settings.solidity_scale == SolidityScale::p95;
    frame.solidity_scale = std::max<double>(1, p95 ? cells.rho_p95 : cells.rho_max);
    frame.solidity_limit = 1;  // never reached with the maximum
    frame.forward = view.forward();
    return frame;
}

template <int D>
void begin_frame(State<D>& state, const Frame<D>& frame) {
    const std::size_t cells = frame.cells->cell_count(), primitives = frame.primitives->size();
    if (state.marks.size() != cells || state.primitive_frame.size() != primitives ||
        state.frame == State<D>::last_frame) {
        state.marks.assign(cells, {});
        state.primitive_frame.assign(primitives, 0);
        state.frame = 0;
    }
    ++state.frame;
    state.front.clear();
    state.front_is_stale = false;
    state.touched.clear();
    state.order.clear();
    static_cast<Counters&>(state) = {};
    state.step = 0;
    state.seed = none;
}

template <int D>
const Front::Entry* front_top(State<D>& state) {
    if (state.front_is_stale) {
        state.front.clear();
        for (std::uint32_t cell = 0; cell < state.marks.size(); ++cell)
            if (const CellMark mark = state.mark(cell); mark.state == CellState::enqueued)
                state.front.push({mark.key, mark.stamp, cell});
        state.front_is_stale = false;
    }
    const std::uint32_t enqueued = state.frame << 2 | static_cast<std::uint32_t>(CellState::enqueued);
    return state.front.top([&](const Front::Entry& entry) {
        const auto& mark = state.marks[entry.cell];
        return mark.frame_and_state == enqueued && mark.stamp == entry.stamp;
    });
}

template <int D>
std::uint64_t state_hash(const State<D>& state) {
    Hash hash;
    for (std::uint32_t cell = 0; cell < state.marks.size(); ++cell) {
        const CellMark mark = state.mark(cell);
        hash.add(mark.key);
        hash.add(static_cast<std::uint64_t>(mark.stamp) << 8 | static_cast<std::uint64_t>(mark.state));
    }
    for (std::uint32_t i = 0; i < state.touched_count; ++i) hash.add(state.touched[i]);
    for (const std::uint32_t count : {state.touched_count, state.rendered_count, state.spent, state.front_size,
                                      state.next_stamp, state.step, state.partial_cell, state.offset})
        hash.add(count);
    return hash.value();
}

bool cell_in_view(const CellComplex<2>& cells, const View<2>& view, std::uint32_t cell) {
    if (view.all_round) return true;
    const auto corners = cells.corners_of(cell);
    std::array<Vec<2>, 4> at;  // a triangle or a square
    for (std::size_t i = 0; i < corners.size(); ++i) at[i] = cells.points[corners[i]];
    return in_view(view, std::span<const Vec<2>>(at).first(corners.size()));
}

bool cell_in_view(const CellComplex<3>& cells, const View<3>& view, std::uint32_t cell) {
    const auto corners = cells.corners_of(cell);
    std::array<Vec<3>, 8> at;  // a tetrahedron or a cube
    for (std::size_t i = 0; i < corners.size(); ++i) at[i] = cells.points[corners[i]];
    return in_view(view, std::span<const Vec<3>>(at).first(corners.size()));
}

template <int D>
std::vector<std::uint32_t> seed_cells(const Frame<D>& frame) {
    const CellComplex<D>& cells = *frame.cells;
    const Vec<D>& eye = frame.view.eye;
    if (const std::uint32_t holding = locate(cells, eye); holding != none) return {holding};
    struct Candidate {
        bool out_of_view;
        double distance;
        std::uint32_t cell;
        auto operator<=>(const Candidate&) const = default;
    };
    std::vector<Candidate> candidates;
    for (const std::uint32_t cell : cells.border_cells)
        for (const HalfFacet& half : cells.facets_of(cell))
            if (half.neighbour == none && facet_side(cells, half, eye) < 0)
                candidates.push_back(
                    {!cell_in_view(cells, frame.view, cell), distance_to_facet(cells, half.facet(), eye), cell});
    std::sort(candidates.begin(), candidates.end());
    std::vector<std::uint32_t> seeds;
    for (const Candidate& c : candidates) {
        if (!seeds.empty() && (frame.settings.seeds == Seeds::one || c.out_of_view)) break;
        if (std::find(seeds.begin(), seeds.end(), c.cell) == seeds.end()) seeds.push_back(c.cell);
    }
    return seeds;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                             \
    template Frame<D> make_frame<D>(const std::vector<Primitive<D>>&, const CellComplex<D>&, const View<D>&, \
                                    const Settings&, std::span<const std::uint8_t>);                         \
    template void begin_frame<D>(State<D>&, const Frame<D>&);                                                \
    template const Front::Entry* front_top<D>(State<D>&);                                                    \
    template std::uint64_t state_hash<D>(const State<D>&);                                                   \
    template std::vector<std::uint32_t> seed_cells<D>(const Frame<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
