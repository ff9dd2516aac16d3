// Laying a figure out: from what its pages say to the places of all of it (layout.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/draw/solid_list.h"
#include "shell/figure/figure_size.h"
#include "shell/figure/layout.h"

namespace sightline {

/// Throws InputError for sizes that are no numbers or out of range.
void check_size(const FigureSize& size);

/// One layout for each page; frames and boxes lie at the same places on all of them.
/// Throws InputError when the size is out of range or too small for the content.
std::vector<Layout> lay_out(std::span<const Figure> pages, const FigureSize& size, const Font& font);

}  // namespace sightline
