// What an author or a lecturer writes into a picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/geometry/vec.h"

namespace sightline {

template <int D>
struct Note {
    enum class Kind : std::uint8_t { text, arrow, ring, callout };
    enum class Anchor : std::uint8_t { point, cell, primitive };
    Kind kind = Kind::text;
    Anchor anchor = Anchor::point;
    Vec<D> point{};            ///< anchor point, scene units
    std::uint32_t index = 0;   ///< anchored cell (its centre) or primitive (its middle)
    Vec<2> offset_pt{0, 12};   ///< where the text, or a callout's number, stands from the anchor: x right, y up, points
    std::string text;          ///< callout: what is explained beside its number
    std::uint32_t number = 0;  ///< callout
    std::uint32_t first_step = 0, last_step = 0xffffffffu;  ///< shown in these steps only
};

inline constexpr auto note_kind_words = std::to_array<std::string_view>({"text", "arrow", "ring", "callout"});
inline constexpr auto note_anchor_words = std::to_array<std::string_view>({"point", "cell", "primitive"});

}  // namespace sightline
