// Colours of the solids in 3D pictures, by meaning.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/draw/solid_list.h"
#include "core/session/settings.h"

namespace sightline {

/// Indices of SolidList::styles in every picture; heat map steps follow after `count`. A cell's look is that of its
/// faces, or of its edges when it is drawn as wireframe.
enum class SolidLook : std::uint8_t {
    clean,
    enqueued,
    projected,
    unseen,
    only_here,   ///< edges of cells of two sessions beside each other: projected by this one only
    only_there,  ///< by the other one only
    border,      ///< edges on faces of cells
    plain,       ///< triangles, where nothing is said about visibility: rendered
    rest,        ///< and not rendered
    rendered,    ///< visible and rendered
    missed,      ///< visible, not rendered
    wasted,      ///< rendered, but hidden
    other,       ///< neither
    fresh,       ///< rendered in the last step
    completed,   ///< cells projected by a round that completes the picture
    hidden,      ///< cells in the front, tested by a round and hidden
    added,       ///< triangles rendered by rounds
    level_1,     ///< triangles of levels that stand in for objects, from fine to coarse
    level_2,
    level_3,    ///< and coarser ones
    postponed,  ///< boxes: covered when popped, so that they come after all others
    count,
};

/// One per SolidLook.
const std::vector<SolidStyle>& solid_styles(Palette palette);

/// Of what is drawn as translucent.
inline constexpr std::uint8_t translucent_alpha = 80;

}  // namespace sightline
