// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/cells/seen_before.h"

#include <algorithm>

#include "core/run/screen.h"
#include "core/space/cell_in_view.h"

namespace sightline {

template <int D>
std::shared_ptr<const FrameHistory> cells_that_show(const Problem<D>& problem, const Marks& marks,
                                                    std::span<const Met> met) {
    Screen<D> screen;
    screen.show(problem, met, static_cast<std::uint32_t>(met.size()));
    std::vector<std::uint8_t> shown(problem.primitives().size());
    for (const std::uint32_t id : screen.image().image().ids)
        if (id != none) shown[id] = 1;
    FrameHistory history;
    history.cells.assign(problem.cells->cell_count(), 0);
    for (std::uint32_t cell = 0; cell < marks.size(); ++cell) {
        if (marks[cell].state != CellState::projected) continue;
        const auto primitives = problem.cells->primitives_of(cell);
        history.cells[cell] =
            std::any_of(primitives.begin(), primitives.end(), [&](std::uint32_t id) { return shown[id] != 0; });
    }
    return std::make_shared<const FrameHistory>(std::move(history));
}

template <int D>
std::vector<std::uint32_t> cells_seen_before(const Problem<D>& problem) {
    const CellComplex<D>& cells = *problem.cells;
    if (!problem.history || problem.history->cells.size() != cells.cell_count()) return {};
    std::vector<std::pair<double, std::uint32_t>> found;
    for (std::uint32_t cell = 0; cell < cells.cell_count(); ++cell) {
        if (!problem.history->cells[cell] || !cell_in_view(cells, problem.view, cell)) continue;
        const Vec<D> away = cells.centre(cell) - problem.view.eye;
        found.emplace_back(glm::dot(away, away), cell);
    }
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> seen;
    for (const auto& [distance, cell] : found) seen.push_back(cell);
    return seen;
}

#define SIGHTLINE_INSTANTIATE(D)                                                                     \
    template std::shared_ptr<const FrameHistory> cells_that_show<D>(const Problem<D>&, const Marks&, \
                                                                    std::span<const Met>);           \
    template std::vector<std::uint32_t> cells_seen_before<D>(const Problem<D>&);
SIGHTLINE_INSTANTIATE(2)
SIGHTLINE_INSTANTIATE(3)
#undef SIGHTLINE_INSTANTIATE

}  // namespace sightline
