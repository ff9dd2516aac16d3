// How much of one primitive the eye sees, from where to where, and what hides the rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/words.h"
#include "core/truth/reference.h"

namespace sightline {

/// Why something is not seen at all, where nothing hides it.
enum class Unseen : std::uint8_t {
    no,           ///< it is seen, or something hides it
    outside,      ///< it lies outside the view
    turned_away,  ///< 3D: it turns its back to the eye
    edge_on,      ///< 2D: it lies on a line through the eye
    no_pixel,     ///< 3D: it covers no pixel's centre
};
template <>
inline constexpr auto words<Unseen> = std::to_array<std::string_view>({"no", "outside", "turned away", "edge-on",
                                                                       "no pixel"});

/// What is seen in place of a part of a primitive.
struct Hider {
    std::uint32_t primitive = none;
    double share = 0;  ///< of the part of the hidden one that lies in the view
};

struct PrimitiveSight {
    Unseen unseen = Unseen::no;
    double share = 0;                  ///< that is seen, of the part in the view: of its angle (2D) or its pixels (3D)
    std::vector<Hider> hiders;         ///< largest share first, then by id; with `share` they add up to 1
    std::vector<VisiblePiece> pieces;  ///< 2D: the stretches that are seen, counter-clockwise about the eye
    std::size_t pixels = 0;            ///< 3D: whose centres it covers, hidden ones too
    std::size_t seen_pixels = 0;       ///< 3D
    std::array<int, 4> seen_box{};     ///< 3D: first and last column, first and last row of seen_pixels, from the top
};

/// 2D: exact, over the directions in which the primitive lies; O(n log n).
PrimitiveSight sight_of(const Scene<2>& scene, const View<2>& view, const Reference& reference,
                        std::uint32_t primitive);
/// 3D: over the pixels of the reference's image. At the primitive's border a pixel may be counted or left out.
PrimitiveSight sight_of(const Scene<3>& scene, const View<3>& view, const Reference& reference,
                        std::uint32_t primitive);

}  // namespace sightline
