// What can happen to the neighbour across a facet of the cell just projected (TVCG fig. 4, lines 6-10).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/run/step.h"

namespace sightline {

/// Change::rule of methods that order cells. Those that leave the neighbour alone (border, projected, unseen) are not
/// recorded: they follow from the marks, since a projected or unseen cell stays one.
enum class Rule : std::uint8_t {
    border,          ///< there is no neighbour
    projected,       ///< projected before: left alone
    enqueued,        ///< was clean: now in the front
    reenqueued,      ///< was in the front: now there with the new key and a new stamp
    kept,            ///< was in the front and keeps its key (on_reenqueue = min or max, or a method without updates)
    marked_unseen,   ///< was clean and lies outside the view: now unseen
    unseen,          ///< found outside the view before: left alone
    tested_seen,     ///< cPLP, in the front: a pixel of it lies before all that is drawn (Change::via); it stays there
    tested_hidden,   ///< cPLP, in the front: no pixel does; it stays there
    projected_now,   ///< cPLP: was in the front, whatever its place
    tested_without,  ///< cPLP test=item, in the front: others show at all its pixels (via: of one); it stays
    lost,            ///< cPLP listing=printed: its id was not read; it left the front (via: whose id was; none: hidden)
    tile_off,        ///< cPLP test=item, a tile: no id shows in it; it is read no more
};
inline constexpr auto rule_words = std::to_array<std::string_view>(
    {"border", "projected before", "enqueued", "re-enqueued", "kept", "marked unseen", "unseen before", "tested, seen",
     "tested, hidden", "projected", "tested, no pixel of its own", "lost", "switched off"});

/// Whether it says what a round of cPLP found out about a cell of the front.
inline bool is_test(const Change& change) {
    const Rule rule{change.rule};
    return rule == Rule::tested_seen || rule == Rule::tested_hidden || rule == Rule::tested_without ||
           rule == Rule::lost;
}

}  // namespace sightline
