// Whether one primitive hides another alone or only several do together: the occluder fusion of TVCG 1 and 2.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/view.h"
#include "core/truth/id_image.h"

namespace sightline {

enum class Hiding : std::uint8_t {
    none,   ///< visible, met by no ray, or unknown
    alone,  ///< one primitive lies in front of all of it that is in view
    fused   ///< none does; several together hide it
};

/// 2D: exact. `zeta`: layering_numbers of the same primitives and view. Time grows with the square of the number of
/// primitives in view.
std::vector<Hiding> hiding(std::span<const Primitive<2>> primitives, const View<2>& view,
                           std::span<const std::uint32_t> zeta);

/// 3D: of the primitives that the first layers (DrawIds) show, but not the very first one, by the pixels at which they
/// do. Where a primitive lies deeper than the layers go nothing is known; such pixels could only take away one that
/// hides it alone, so that those said to be fused are. Exact where the layers go through the whole scene.
std::vector<Hiding> hiding(std::span<const IdImage> layers, std::size_t primitive_count);

/// Those fused over those hidden; NaN where none is.
double fused_share(std::span<const Hiding> all);

}  // namespace sightline
