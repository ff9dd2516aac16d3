// The rounds that complete a run of cells (cPLP, the gem): test the front against what is drawn, project what is seen.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run/screen.h"

namespace sightline {

template <int D>
struct Rounds {
    std::uint32_t done = 0;
    std::vector<std::uint8_t> hidden{};  ///< per cell: tested and hidden; what is drawn only comes nearer, so it stays
    std::vector<std::uint32_t> round_of{};  ///< per cell: the round that projected it; 0: none
    bool only_winners = false;              ///< of a cell's primitives those that win a pixel are rendered
    std::vector<std::uint32_t> winners{};   ///< of the cell that is being projected
    Screen<D> screen{};

    void begin(std::size_t cell_count) {
        done = 0;
        hidden.assign(cell_count, 0);
        round_of.assign(cell_count, 0);
        screen.forget();
    }
};

/// Substeps of a round: 0 draws the depth image, 1 has the front before it is tested, 2 + i tests its cell i; the last
/// one also projects those that are seen.
inline constexpr std::uint32_t first_test_substep = 2;

}  // namespace sightline
