// How a variant looks in every chart, of the window and of the lab: one colour, one line, one marker.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/draw/draw_list.h"

namespace sightline {

enum class ChartMarker : std::uint8_t { circle, square, triangle, diamond, triangle_down, pentagon };
inline constexpr std::size_t marker_count = 6;

struct VariantLook {
    Colour colour;
    std::span<const float> dash{};  ///< line, gap, line, gap, … in widths of the line; empty: solid
    ChartMarker marker = ChartMarker::circle;
    bool filled = true;  ///< the marker; rings and the like are for the leaves of a tree

    bool operator==(const VariantLook& other) const;
    /// Whether the lines alone are equal.
    bool same_line(const VariantLook& other) const;
};

/// The looks of variants ("published on_reenqueue=min") that are shown together, in their order. Equal variants look
/// equal, however their assignments are ordered and their numbers written; others differ.
///
/// A method of the table has the colour and the marker of its row, and a solid line, whatever else is shown. A variant
/// has a shade of its method's hue, a dashed line and a marker by a hash of its text. Only where a shown variant that
/// stands before it in the alphabet has that line already, it takes the next free one: 15 of a hue differ by line, the
/// next 75 by marker. A method that the program's own table does not have takes a free row by a hash of its id.
std::vector<VariantLook> variant_looks(std::span<const std::string> variants);

/// "#0072b2"
std::string hex_colour(const Colour& colour);

}  // namespace sightline
