// What a run misses: the wrong pixels of its picture as regions, each with the primitives that should be there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/measure/wrong_region.h"
#include "core/session/session.h"

namespace sightline {

struct Missed {
    std::size_t wrong = 0, pixels = 0;  ///< wrong ones, and all of the reference's image (2D: of its one row)
    std::vector<WrongRegion> regions;   ///< largest first
    /// Visible primitives that are not rendered, most pixels first, then by id. 2D: one may own no pixel.
    std::vector<PixelCount> primitives;
    double share() const { return pixels > 0 ? static_cast<double>(wrong) / static_cast<double>(pixels) : 0; }
};

/// Of what is rendered at the session's position. Asks for the reference. Cost: pixels + primitives.
template <int D>
Missed missed_by(const Session<D>& session);

/// "column 40", or "columns 40 to 88".
std::string range_words(int first, int last, const std::string& what);

/// "812 pixels, columns 40 to 88, rows 10 to 31"
template <int D>
std::string region_words(const WrongRegion& region);

/// "triangle 566 (wall41)", or "triangle 566" where the scene names no objects.
template <int D>
std::string primitive_name(const Scene<D>& scene, std::uint32_t primitive);

}  // namespace sightline
