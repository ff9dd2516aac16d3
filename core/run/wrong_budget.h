// A budget that follows the scene: as many primitives as leave few enough pixels wrong, guessed from the frames before.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sightline {

/// What the last frames would have needed.
struct NeededBudgets {
    std::array<std::uint32_t, 8> last{};  ///< a ring: frame i is last[i % 8]
    std::size_t count = 0;                ///< of all frames
};

/// A frame has been drawn with `budget`; `needed`: the smallest budget that would have done, none where even this one
/// left too many pixels wrong, which is all that a frame knows of what it did not draw: twice its budget is noted then.
void note_needed(NeededBudgets& frames, std::uint32_t budget, std::uint32_t needed);

/// The most that one of the last frames needed, so that one frame that is easily drawn does not starve the next, and no
/// more than `total`; before the first frame `total`.
std::uint32_t predict_needed(const NeededBudgets& frames, std::uint32_t total);

}  // namespace sightline
