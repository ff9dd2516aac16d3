// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cells/seed_cells.h"

#include <algorithm>
#include <utility>

#include "core/space/cell_in_view.h"

namespace sightline {

template <int D>
std::vector<std::uint32_t> seed_cells(const Problem<D>& problem, Seeds wanted) {
    const CellComplex<D>& cells = *problem.cells;
    const Vec<D>& eye = problem.view.eye;
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
                    {!cell_in_view(cells, problem.view, cell), distance_to_facet(cells, half.facet(), eye), cell});
    std::sort(candidates.begin(), candidates.end());
    std::vector<std::uint32_t> seeds;
    std::vector<std::uint8_t> taken(cells.cell_count());
    for (const Candidate& c : candidates) {
        if (!seeds.empty() && (wanted == Seeds::one || c.out_of_view)) break;
        if (!std::exchange(taken[c.cell], 1)) seeds.push_back(c.cell);
    }
    return seeds;
}

template std::vector<std::uint32_t> seed_cells<2>(const Problem<2>&, Seeds);
template std::vector<std::uint32_t> seed_cells<3>(const Problem<3>&, Seeds);

}  // namespace sightline
