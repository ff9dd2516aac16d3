// Where a label stands on whatever it is put: the window's picture or a figure's page. y down, any unit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/draw_list.h"

namespace sightline {

/// How large a label is in the font of its paper.
struct LabelSize {
    double width = 0;        ///< of the text
    double half_height = 0;  ///< of text and halo
    double margin = 0;       ///< beside the text
    double radius = 0;       ///< of a disc behind it; 0 without one
};

/// Of text, halo and disc, which share their centre. `point`: what the label speaks of, its offset added. Labels stay
/// inside the frame: those near its border move in.
Box<2> label_box(const Label& label, const Vec<2>& point, const LabelSize& size, const Box<2>& frame);

/// Where the leader to what a label speaks of leaves the label's box.
Vec<2> leader_start(const Box<2>& box, const Vec<2>& tip);

}  // namespace sightline
