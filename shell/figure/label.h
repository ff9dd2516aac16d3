// Where the labels of a draw list stand on the page, and what that leaves out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shell/figure/inset.h"
#include "shell/figure/layout.h"

namespace sightline {

struct PlacedLabel {
    std::size_t label = 0;      ///< index in the list
    std::vector<TextRun> runs;  ///< its lines; none when the label is a bare disc
    Vec<2> centre{};            ///< of text and disc
    double radius = 0;          ///< of the disc behind it; 0 without one
    Rect box;                   ///< of text, halo and disc
    std::optional<Vec<2>> tip;  ///< of the leader from the box, where there is one
};

/// A label as if it were alone. Labels stay inside their panel: those near its border move in. Nothing when the label's
/// point lies outside.
std::optional<PlacedLabel> place_label(const Label& label, const Layout::Panel& panel, const Layout& layout,
                                       const Font& font);

/// Everything written over one panel's picture.
struct PlacedTexts {
    std::vector<PlacedInset> insets;
    std::vector<PlacedLabel> labels;
    std::vector<std::size_t> no_room;  ///< labels that are left out, though their points lie in the panel
};

/// In one pass: insets, a legend that stands in the panel and the eye first, then notes, then labels of the picture
/// (stand_labels). Nothing overlaps. Notes too long for a panel are broken into lines, other texts set smaller.
PlacedTexts place_texts(const Figure::Panel& content, const Layout::Panel& panel, const Layout& layout,
                        const Font& font);

/// What the figure does not show as it was asked for: labels that found no room, notes that lie outside, smaller text.
/// `asked_pt`: the font that was asked for.
std::vector<std::string> left_out(const Figure& figure, const Layout& layout, const Font& font, double asked_pt);

}  // namespace sightline
