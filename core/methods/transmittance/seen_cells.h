// Which cells meet the view, asked once for each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/run/problem.h"
#include "core/space/cell_in_view.h"

namespace sightline {

/// A cache: what it says depends on the view and the cell only.
template <int D>
class SeenCells {
public:
    explicit SeenCells(std::size_t cells) : known_(cells, Known::nothing) {}

    bool holds(const Problem<D>& problem, std::uint32_t cell) const {
        Known& known = known_[cell];
        if (known == Known::nothing)
            known = cell_in_view(*problem.cells, problem.view, cell) ? Known::inside : Known::outside;
        return known == Known::inside;
    }

private:
    enum class Known : std::uint8_t { nothing, inside, outside };
    mutable std::vector<Known> known_;
};

}  // namespace sightline
