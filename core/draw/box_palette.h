// Colours of pictures of methods that hide boxes behind occluders: those of Coorg and Teller's figures 4, 8, 10 and 11.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/draw/draw_list.h"
#include "core/draw/solid_list.h"
#include "core/session/settings.h"

namespace sightline {

/// Styles that such a picture adds after all others of its list; legends know them by their names.
enum class BoxLook : std::uint8_t {
    invisible,  ///< boxes
    shown,      ///< PARTIAL or VISIBLE
    outside,    ///< the view
    eye_leaf,   ///< that holds the eye
    last,       ///< tested last
    selected,
    actual,            ///< occluders
    potential,         ///< large enough, but others are larger
    partial_eyes,      ///< region 2 of figure 4a: eyes from which an occluder hides a part of a box
    hidden_eyes,       ///< region 3: all of it
    supporting,        ///< planes: satisfied
    supporting_fails,  ///< not satisfied
    separating,
    separating_fails,
    own,  ///< of the occluder: the box lies beyond it
    own_fails,
    lit,         ///< the one that is pointed out
    region,      ///< eyes from which an occluder is large enough (figure 8b)
    region_box,  ///< the box around them
    count,
};
const std::vector<Style>& box_looks(Palette palette);

/// The same for solids.
enum class SolidBoxLook : std::uint8_t {
    invisible,
    shown,
    outside,
    actual,
    potential,
    satisfied,
    fails,
    count,
};
const std::vector<SolidStyle>& solid_box_looks(Palette palette);

/// What a style of these tables means, and how a legend shows it; nullptr: it is none of them.
struct BoxEntry {
    std::string_view name;
    ShapeKind swatch;
    const char* text;
};
const BoxEntry* box_entry(std::string_view name);
/// Its place among the rows of a legend, from 0.
std::size_t row_of(const BoxEntry& entry);

}  // namespace sightline
