// What the last step chose: the cell that it took, the one that came next, and the keys that it changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/session/session.h"

namespace sightline {

struct Choice {
    std::uint32_t taken = none, next = none;  ///< cells; none: the step took no cell, or it was alone in the front
};

/// Of the step at the session's position.
template <int D>
Choice choice_of(const Session<D>& session);

/// The cell that comes first in the front, whose label is not to be missed; none where the front has no cell.
template <int D>
std::uint32_t first_in_front(const Session<D>& session);

/// What a cell's label says of the number that the session's settings ask for. Of a key: "26 · 0.274" for the cell taken
/// and the next one, "13 · 0.301 → 0.696" where the step gave a waiting cell another key. Else the number alone.
template <int D>
std::string cell_label(const Session<D>& session, const Choice& choice, std::uint32_t cell, double number);

}  // namespace sightline
