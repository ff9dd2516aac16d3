// Colours and line styles by meaning. States differ in lightness and hatch, so that they stay apart in greyscale.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "core/draw/draw_list.h"
#include "core/session/settings.h"

namespace sightline {

/// Indices of DrawList::styles in every picture; heat map steps follow after `count`.
enum class Look : std::uint16_t {
    clean,
    enqueued,
    projected,
    unseen,
    only_here,   ///< cells of two sessions beside each other: projected by this one only
    only_there,  ///< by the other one only
    tessellation,
    other,     ///< primitives: not rendered and not visible
    rendered,  ///< visible and rendered
    missed,    ///< visible, not rendered
    wasted,    ///< rendered, but hidden
    view,
    display_view,
    eye,
    seed,
    selected,
    last,
    eye_ray,
    normal,
    penalty,
    chain,
    selected_primitive,
    note,
    completed,  ///< projected by a round that completes the picture
    hidden,     ///< in the front, tested by a round and hidden
    next,       ///< the cell that came next when the last one was taken
    level_1,    ///< primitives of levels that stand in for objects, from fine to coarse
    level_2,
    level_3,    ///< and coarser ones
    postponed,  ///< boxes: covered when popped, so that they come after all others
    count,
};

/// Of a level from 1: `first`, the one behind it, or the third.
template <typename LevelLook>
LevelLook level_look(LevelLook first, std::uint32_t level) {
    return static_cast<LevelLook>(static_cast<std::uint32_t>(first) + std::min(level, 3u) - 1);
}

struct Colours {
    Colour background, ink, halo, accent;
    std::vector<Style> looks;   ///< one per Look
    std::vector<Colour> heat;   ///< from low to high
    std::vector<Colour> walls;  ///< muted, to tell segments apart in what the eye sees
    Colour wrong;               ///< pixels that show something else than they should
};

const Colours& colours(Palette palette);

/// The colour at a share in [0, 1] of the way along the stops, which are evenly spread; two stops or more.
Colour between(const std::vector<Colour>& stops, double share);

/// CIE lightness L* in [0, 100] of an opaque colour (sRGB, D65).
double lightness(const Colour& colour);

/// WCAG contrast of two opaque colours in [1, 21].
double contrast(const Colour& a, const Colour& b);

}  // namespace sightline
